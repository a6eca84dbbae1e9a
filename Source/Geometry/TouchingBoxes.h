// How near each other the faces of a mesh are: what searches by bounding boxes have to look at.
#pragma once

#include "Geometry/Mesh.h"

#include <cstddef>
#include <optional>

namespace idiophone {

/// The pairs of faces whose bounding boxes overlap or touch, or nothing where they are more than
/// `most`; n log³ n for n faces besides. Indices are valid, coordinates finite.
std::optional<std::size_t> touchingBoxes(const Mesh& mesh, std::size_t most);

} // namespace idiophone
