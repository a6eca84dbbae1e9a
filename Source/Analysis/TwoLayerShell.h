// The shell as two sheets of springs: still springs and masses, but with stiffness against bending,
// on triangles of any shape. Good for bars, plates, bowls and other sheets of one thickness; not
// for solids.
#pragma once

#include "Analysis/VibrationModel.h"
#include "Geometry/Mesh.h"
#include "Object/Material.h"

namespace idiophone {

/// The mesh is the mid-surface; copies of it lie at ± t/√12 along the vertex normals, each with
/// half of the mass and half of the stiffness, so that membrane stiffness Y t and bending stiffness
/// Y t³/12 are both right. Each triangle of a layer has three springs that pull on all its corners,
/// one against change of area and two against change of shape: together the plane-stress triangle
/// of the material's ν, which for equilateral triangles and ν = 1/3 is that of springs along the
/// edges. At every vertex a post joins the layers; at every edge a pair of crossed braces resists
/// transverse shear with G = Y/(2(1+ν)) and Cowper's shear coefficient.
///
/// The two braces of an edge work on the difference of their elongations: their sum, which would
/// stiffen the membrane, is left free.
///
/// Rows 6v … 6v+2 are the displacement of vertex v in the upper layer (along the normal), rows
/// 6v+3 … 6v+5 in the lower. The mesh is as repairMesh leaves it.
VibrationModel twoLayerShell(const Mesh& mesh, const Material& material, double thicknessMetres);

/// Half the distance of the two layers: t/√12.
double layerOffsetMetres(double thicknessMetres);

/// [N×3 × modes]: the displacement of the mid-surface, the mean of both layers, for shapes [6N ×
/// modes] of the model. Rows 3v … 3v+2 are vertex v's.
Eigen::MatrixXd midSurfaceShapes(const Eigen::MatrixXd& shapes);

} // namespace idiophone
