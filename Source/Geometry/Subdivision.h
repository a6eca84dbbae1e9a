// Divides faces into four, with or without smoothing.
#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/SparseCore>

namespace idiophone {

struct FaceSplit {
    Eigen::SparseMatrix<double>
        vertices;          ///< [V×N] new vertices from the old ones, which come first
    Eigen::MatrixXi faces; ///< [4F×3]
};

/// Splits every face into four by the middles of its sides. The surface stays.
FaceSplit splitInFour(const Mesh& mesh);

/// Subdivides the mesh `times` times after Loop (1987), by libigl: every face becomes four, towards
/// a surface with continuous tangents. A body that rolls over a coarse mesh would feel its edges.
/// Drops vertices without a face. Returns the mesh unchanged if more than two faces meet in an
/// edge, if two faces run along an edge in the same direction (Möbius strip), or if a face has a
/// corner twice.
Mesh subdivided(const Mesh& mesh, int times);

} // namespace idiophone
