// Smooths meshes, so that a body that rolls over a coarse mesh does not bump over its edges.
#pragma once

#include "Geometry/Mesh.h"

namespace idiophone {

/// Subdivides the mesh `times` times after Loop (1987), by libigl: every face becomes four, towards
/// a surface with continuous tangents. Drops vertices without a face. Returns the mesh unchanged if
/// more than two faces meet in an edge, if two faces run along an edge in the same direction
/// (Möbius strip), or if a face has a corner twice.
Mesh subdivided(const Mesh& mesh, int times);

} // namespace idiophone
