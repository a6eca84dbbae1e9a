// The closed surface between a body and the air, and its motion as a function of the analysed mesh.
// Closed bodies are kept unchanged; sheets get two sides and a rim.
#pragma once

#include "Mesh/Mesh.h"
#include "Object/Result.h"
#include "Object/WorkControl.h"

#include <Eigen/SparseCore>
#include <utility>
#include <vector>

namespace idiophone {

struct ClosedSurface {
    Mesh mesh; ///< V vertices, F faces; every component closed and oriented outward
    /// [V×N] the share of each analysed vertex's motion in each vertex here; rows sum to 1.
    Eigen::SparseMatrix<double> motion;

    /// Returns [F×M] outward normal shapes of the faces, averaged over their corners. Rows 3v …
    /// 3v+2 of `shapes` [3N×M] belong to vertex v.
    Eigen::MatrixXd normalShapes(const Eigen::MatrixXd& shapes) const;
};

/// Returns the boundary edges of faces [F×3] in ascending order, directed as in their face. An edge
/// counts once for each use that no face of the opposite direction cancels.
std::vector<std::pair<int, int>> boundaryEdges(const Eigen::MatrixXi& faces);

/// Keeps closed components. In open ones, each face becomes two, offset by half the thickness along
/// the vertex normals. Four triangles close each boundary edge, which keeps the symmetries of a
/// sheet. `mesh` is as repairMesh leaves it. Error: an open component without thickness.
Result<ClosedSurface> closedSurface(const Mesh& mesh, double thicknessMetres);

/// Splits every face into four. Keeps shape and symmetries.
ClosedSurface withFacesSplit(const ClosedSurface& surface);

/// Covers the surface with new triangles of about this edge length. They move like the nearest
/// points of the old ones. Symmetries are lost. Errors: those of remesh.
Result<ClosedSurface>
remeshed(const ClosedSurface& surface, double edgeLengthMetres, const WorkControl& control = {});

} // namespace idiophone
