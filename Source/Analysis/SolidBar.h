// An undercut bar as finite elements: a regular, mirror-symmetric grid that moves smoothly with the
// bar's measures, so that pitch is a smooth function of them while the bar is tuned.
#pragma once

#include "Analysis/TetMesh.h"
#include "Analysis/UndercutBar.h"

#include <vector>

namespace idiophone {

/// How many boxes of six tetrahedra a bar is divided into, each way.
struct BarGrid {
    int along = 32;  ///< a multiple of 4, ≥ 8
    int across = 4;  ///< even, ≥ 2
    int through = 2; ///< ≥ 1
};

/// Some of the surface, light and closed: to draw, and with what lies on top to strike.
struct BarOutline {
    static constexpr int topAcross = 3; ///< vertices on a line across the top: edges and middle
    /// The surface's vertex of each of the outline's. Those on top come first and ascend: the front
    /// edge along x, the middle, the back edge.
    std::vector<int> surfaceVertices;
    int topCount = 0;
    Mesh mesh;
};

/// The bar's length lies along x, its width along y; its top is the plane z = 0.
struct SolidBar {
    TetMesh elements; ///< the nodes on the surface, mid-edge nodes among them, come first
    Mesh surface;     ///< closed; its vertices are those nodes
    BarOutline outline;
};

/// Mirror-symmetric in x and y, with lines across at the arch's edges.
SolidBar solidBar(const UndercutBar& bar, const BarGrid& grid);

} // namespace idiophone
