// The eye that looks at a scene: it turns around the scene's middle and comes nearer or farther.
#pragma once

#include "Editor/ObjectScene.h"

#include <Eigen/Geometry>
#include <array>
#include <vector>

namespace idiophone {

struct ViewRay {
    ScenePlace origin{};
    ScenePlace direction{}; ///< not of unit length
};

class OrbitCamera {
public:
    /// Looks at a scene from the player's side so that all of its points are seen, at any shape of
    /// the window, and little else. Turn and zoom stay as they are. `points` is not empty.
    void lookAt(std::vector<ScenePlace> points);

    /// In radians; the eye stays above the horizon and below the zenith.
    void turnBy(float aroundRadians, float upRadians);
    /// Above 1 nearer; within a twentieth and five times of the distance that shows all.
    void zoomBy(float factor);
    /// Moves the scene sideways and up, in heights of the window.
    void moveBy(float right, float up);
    /// As at first.
    void reset();

    ScenePlace eye(float aspect) const;
    /// [16] column-major, from the scene to OpenGL's clip space; `aspect` is width over height.
    std::array<float, 16> viewProjection(float aspect) const;
    /// Through a place of the window, x and y from −1 to 1, right and up.
    ViewRay rayThrough(float x, float y, float aspect) const;
    /// Where a place of the scene is seen, x and y as above.
    std::array<float, 2> seenAt(const ScenePlace& place, float aspect) const;

private:
    struct Axes {
        Eigen::Vector3f right, up, forward;
    };
    Axes axes() const;
    struct Eye {
        Eigen::Vector3f place;
        float depthOfMiddle = 0; ///< along the line of sight
    };
    Eye place(float aspect) const;

    std::vector<ScenePlace> seen{{}};
    Eigen::Vector3f middle = Eigen::Vector3f::Zero();
    float reach = 1; ///< from the middle
    float around = initialAround, elevation = initialElevation, zoom = 1;
    float movedRight = 0, movedUp = 0;
    static constexpr float initialAround = -0.2f, initialElevation = 0.62f;
};

} // namespace idiophone
