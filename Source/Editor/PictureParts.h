// Takes a frame of the picture apart into draw calls.
#pragma once

#include "Editor/SceneFrame.h"

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

/// One draw call. Valid as long as the frame.
struct PicturePart {
    SceneObject shape;
    Appearance look;
    Eigen::Matrix4f pose;
    std::optional<std::size_t> object; ///< index in the scene; nothing: furniture or mallet
    std::size_t number = 0;            ///< distinguishes the grain of parts
};

/// The objects or bodies of a frame, their furniture and the mallets.
std::vector<PicturePart> partsOf(const SceneFrame& frame);

/// Returns for each part whether it casts a shadow in the lamp's depth map: all but glass do.
std::vector<bool> shadowCasters(std::span<const PicturePart> parts);

/// The vertices of objects and furniture of a frame where they are, three a triangle. In the order
/// of the buffers if no bodies move.
std::vector<SceneVertex> placedVertices(const SceneFrame& frame);

} // namespace idiophone
