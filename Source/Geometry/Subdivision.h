// Meshes made smooth: what rolls over a coarse mesh would feel its edges.
#pragma once

#include "Geometry/Mesh.h"

namespace idiophone {

/// The mesh subdivided so many times after Loop (1987), by libigl: every face becomes four each
/// time, on the way to a surface whose tangents turn without a step. Vertices without a face are
/// left out. A mesh in which more than two faces meet in an edge, or two that run along it in the
/// same direction, as on a Möbius strip, or a face has a corner twice, stays as it is.
Mesh subdivided(const Mesh& mesh, int times);

} // namespace idiophone
