// An undercut bar as finite elements: a regular, mirror-symmetric grid that moves smoothly with the
// bar's measures, so that pitch is a smooth function of them while the bar is tuned.
#pragma once

#include "Analysis/TetMesh.h"
#include "Analysis/UndercutBar.h"

namespace idiophone {

/// How many boxes of six tetrahedra a bar is divided into, each way.
struct BarGrid {
    int along = 32;  ///< even, ≥ 8
    int across = 4;  ///< even, ≥ 2
    int through = 2; ///< ≥ 1
};

/// The grid whose edges are about `edgeMetres`, no coarser than BarGrid's own bounds.
BarGrid barGrid(const UndercutBar& bar, double edgeMetres);

/// The bar's length lies along x, its width along y; its top is the plane z = 0.
struct SolidBar {
    TetMesh elements; ///< the nodes on the surface, mid-edge nodes among them, come first
    Mesh surface;     ///< closed; its vertices are those nodes
};

/// Mirror-symmetric in x and y, with lines across at the arch's edges.
SolidBar solidBar(const UndercutBar& bar, const BarGrid& grid);

} // namespace idiophone
