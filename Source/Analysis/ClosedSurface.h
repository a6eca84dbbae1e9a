// The closed surface by which a body touches the air, and how it moves with the mesh that was
// analysed: bodies as they are, sheets with their thickness and a rim.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/Result.h"
#include "Object/WorkControl.h"

#include <Eigen/SparseCore>

namespace idiophone {

struct ClosedSurface {
    Mesh mesh; ///< V vertices, F faces; every component closed and oriented outward
    /// [V×N] how much of the motion of each vertex analysed each vertex here shares; rows sum to 1.
    Eigen::SparseMatrix<double> motion;

    /// [F×M] the outward shapes of all faces, the means over their corners, of shapes [3N×M] whose
    /// rows 3v … 3v+2 are vertex v's.
    Eigen::MatrixXd normalShapes(const Eigen::MatrixXd& shapes) const;
};

/// Components that are closed stay as they are. Of the others every face becomes two, at half of
/// the thickness to either side along the vertices' normals, and four triangles close each piece of
/// the boundary, so that symmetries of a sheet are left to it. `mesh` as repairMesh leaves it.
/// Error: an open component without thickness.
Result<ClosedSurface> closedSurface(const Mesh& mesh, double thicknessMetres);

/// Every face cut into four. The shape stays, and so do symmetries.
ClosedSurface withFacesSplit(const ClosedSurface& surface);

/// The surface covered anew with triangles of about this edge length, moving as the nearest points
/// of the former one do. Symmetries are lost. Errors: those of remesh.
Result<ClosedSurface>
remeshed(const ClosedSurface& surface, double edgeLengthMetres, const WorkControl& control = {});

} // namespace idiophone
