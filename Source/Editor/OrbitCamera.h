// The eye that looks at a scene: it turns around the scene's middle and comes nearer or farther.
#pragma once

#include "Editor/ObjectScene.h"

#include <array>

namespace idiophone {

struct ViewRay {
    ScenePlace origin{};
    ScenePlace direction{}; ///< not of unit length
};

class OrbitCamera {
public:
    /// Looks at a scene that lies between two corners from the player's side, so that all of it is
    /// seen at any shape of the window and little else. Turn and zoom stay as they are.
    void lookAt(const ScenePlace& lowest, const ScenePlace& highest);

    /// In radians; the eye stays above the horizon and below the zenith.
    void turnBy(float aroundRadians, float upRadians);
    /// Above 1 nearer; within a twentieth and five times of the distance that shows all.
    void zoomBy(float factor);
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
        ScenePlace right, up, forward;
    };
    Axes axes() const;
    float distance(float aspect) const;

    ScenePlace middle{};
    ScenePlace half{1, 1, 1}; ///< of the scene's box
    float around = initialAround, elevation = initialElevation, zoom = 1;
    static constexpr float initialAround = -0.25f, initialElevation = 0.75f;
};

} // namespace idiophone
