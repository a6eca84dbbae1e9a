// Curves the elements of a remeshed body along the surface that was remeshed. Internal to Analysis.
#pragma once

#include "Analysis/TetMesh.h"
#include "Mesh/SurfaceQuery.h"

namespace idiophone {

/// Moves the mid-edge nodes of the edges of `covering`, the surface of `mesh`, to the nearest
/// points of the true surface. Straight edges would make a round bar of a dozen sides thinner, and
/// its pitch lower by a per cent. Edges stay straight where they would become much longer, as on a
/// wrong side of a thin wall, or where an element would lose most of its volume.
void curveEdges(TetMesh& mesh, const Mesh& covering, const SurfaceQuery& trueSurface);

} // namespace idiophone
