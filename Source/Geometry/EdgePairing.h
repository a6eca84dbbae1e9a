// Finds the face that continues each face across an edge. If more than two faces meet at an edge,
// the pairs follow the solids or sheets that the faces bound. Internal to Geometry.
#pragma once

#include "Mesh/Mesh.h"

#include <array>
#include <vector>

namespace idiophone {

struct EdgePartner {
    int face = -1;              ///< −1 if the surface ends here
    bool sameDirection = false; ///< both faces run along the edge in one direction
};

struct EdgePairing {
    /// [F][3] partner across the edge from corner k to corner k+1. Partners refer to each other.
    std::vector<std::array<EdgePartner, 3>> partners;
    int boundaryEdges = 0;    ///< edges of one face
    int nonManifoldEdges = 0; ///< edges of more than two faces
};

/// Pairs the faces at every edge:
/// - two faces: with each other;
/// - an even number, facing alternately in and out: the two faces on either side of the inside, so
///   that two cubes with a common edge become two cubes (one if they are inside out);
/// - another even number: neighbours around the edge, in the arrangement with the sharper angles;
/// - an odd number: the straightest pair first; one face stays alone.
/// Faces must be neither degenerate nor duplicate.
EdgePairing pairEdges(const Mesh& mesh);

} // namespace idiophone
