// An undercut bar as finite elements. The regular, mirror-symmetric grid moves smoothly with the
// bar's dimensions, so that the pitch is a smooth function of them during tuning.
#pragma once

#include "Analysis/TetMesh.h"
#include "Analysis/UndercutBar.h"

#include <vector>

namespace idiophone {

/// The number of boxes along each axis; a box is six tetrahedra.
struct BarGrid {
    int along = 32;  ///< a multiple of 4, ≥ 8
    int across = 4;  ///< even, ≥ 2
    int through = 2; ///< ≥ 1
};

/// A light, closed mesh of some surface vertices, for display. Strikes use those on top.
struct BarOutline {
    static constexpr int topAcross = 3; ///< vertices on a line across the top: edges and middle
    /// The surface vertex of each outline vertex. The top vertices come first, ascending: the front
    /// edge along x, the middle, the back edge.
    std::vector<int> surfaceVertices;
    int topCount = 0;
    Mesh mesh;
};

/// The bar's length lies along x, its width along y; its top is the plane z = 0.
struct SolidBar {
    TetMesh elements; ///< surface nodes come first, including mid-edge nodes
    Mesh surface;     ///< closed; its vertices are the surface nodes
    BarOutline outline;
};

/// Returns elements mirror-symmetric in x and y, with lines across at the arch's edges.
SolidBar solidBar(const UndercutBar& bar, const BarGrid& grid = {});

} // namespace idiophone
