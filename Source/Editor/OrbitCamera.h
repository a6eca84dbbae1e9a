// The camera: it orbits the middle of the scene, zooms and shifts.
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
    /// Frames a scene from the player's side, so that all points just fit at any aspect ratio.
    /// Keeps turn and zoom. `points` is not empty.
    void lookAt(std::vector<ScenePlace> points);

    /// Turns the camera. It stays above the horizon and below the zenith.
    void turnBy(float aroundRadians, float upRadians);
    /// Above 1 moves nearer. The zoom stays between 0.2 and 20; at 1 the whole scene fits.
    void zoomBy(float factor);
    /// Shifts the scene right and up; the unit is the height of the window.
    void moveBy(float right, float up);
    void reset();

    ScenePlace eye(float aspect) const;
    /// The matrix from the scene to OpenGL's clip space, column-major; `aspect` is width over
    /// height.
    std::array<float, 16> viewProjection(float aspect) const;
    /// The ray through a position in the window; x (right) and y (up) are from −1 to 1.
    ViewRay rayThrough(float x, float y, float aspect) const;

private:
    struct Axes {
        Eigen::Vector3f right, up, forward;
    };
    Axes axes() const;
    struct Eye {
        Eigen::Vector3f place;
        float depthOfMiddle = 0; ///< distance to the middle along the line of sight
    };
    Eye place(float aspect) const;

    std::vector<ScenePlace> seen{{}};
    Eigen::Vector3f middle = Eigen::Vector3f::Zero();
    float reach = 1; ///< radius of the scene
    float around = initialAround, elevation = initialElevation, zoom = 1;
    float movedRight = 0, movedUp = 0;
    static constexpr float initialAround = -0.2f, initialElevation = 0.62f;
};

} // namespace idiophone
