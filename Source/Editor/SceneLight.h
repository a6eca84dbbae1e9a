// The light that reaches surfaces: how much of the sky each vertex sees, and the shadow on the
// floor.
#pragma once

#include "Editor/SceneVertex.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

/// A rectangle on the floor with a grid of texels, in the scene.
struct FloorArea {
    float left = 0, front = 0, width = 0, depth = 0; ///< metres
    float height = 0;                                ///< z of the floor
    int columns = 0, rows = 0;
};

struct SceneLight {
    /// The direction to the middle of the lamp, of unit length. `lighting.glsl` has the same.
    static constexpr ScenePlace lamp{-0.449f, 0.323f, 0.833f};

    std::vector<std::uint8_t> sky; ///< one for each vertex: the visible share of the sky; 255: all
    /// Two for each texel, row by row from the front: the visible share of the lamp, which has a
    /// width, and of the sky.
    std::vector<std::uint8_t> floor;
};

/// Draws depth maps of the triangles from many directions, by the processor. `vertices` has three a
/// triangle. The work is limited: with many vertices, fewer directions are used. Returns nothing if
/// `isAbandoned` becomes true meanwhile.
std::optional<SceneLight> sceneLight(std::span<const SceneVertex> vertices,
                                     const FloorArea& area,
                                     const std::atomic<bool>* isAbandoned = nullptr);

} // namespace idiophone
