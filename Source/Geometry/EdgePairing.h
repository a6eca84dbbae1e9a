// Which face continues which across an edge. Where more than two faces meet, they are paired as the
// solids or sheets that they bound would have it. Internal to Geometry.
#pragma once

#include "Geometry/Mesh.h"

#include <array>
#include <vector>

namespace idiophone {

struct EdgePartner {
    int face = -1;              ///< −1: none, the surface ends here
    bool sameDirection = false; ///< both faces run along the edge the same way: one is turned over
};

struct EdgePairing {
    /// [F][3] across the edge from corner k of the face to corner k+1. Partners name each other.
    std::vector<std::array<EdgePartner, 3>> partners;
    int boundaryEdges = 0;    ///< edges of one face
    int nonManifoldEdges = 0; ///< edges of more than two faces
};

/// Pairs the faces at every edge. An edge of two faces pairs them. Of an even number of faces that
/// look in and out in turn about the edge, those are paired that have the inside between them (two
/// cubes that share an edge come apart as two cubes, or as one when they are inside out); of
/// another even number, neighbours about the edge, in the way with the sharper angles; of an odd
/// number, the straightest pair first, and one stays alone.
/// The faces are neither degenerate nor duplicate.
EdgePairing pairEdges(const Mesh& mesh);

} // namespace idiophone
