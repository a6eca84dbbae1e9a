// How near each other the faces of a mesh are: what searches by bounding boxes have to look at.
#pragma once

#include "Geometry/Mesh.h"

#include <cstddef>
#include <optional>

namespace idiophone {

/// What it takes to look for each face's neighbours in a tree of boxes around faces.
struct BoxSearch {
    std::size_t pairs = 0; ///< of faces whose bounding boxes overlap or touch
    std::size_t boxes = 0; ///< looked at; sound meshes have under a hundred a face
};

/// Nothing where either number is more than that of `most`. Takes some 10 ns a box that is looked
/// at, and n log n for n faces besides. Indices are valid, coordinates finite.
std::optional<BoxSearch> touchingBoxes(const Mesh& mesh, const BoxSearch& most);

} // namespace idiophone
