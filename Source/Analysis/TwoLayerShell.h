// Models a shell as two layers of springs and masses with bending stiffness, on triangles of any
// shape. It suits bars, plates, bowls and other sheets of constant thickness, not solids.
#pragma once

#include "Analysis/VibrationModel.h"
#include "Mesh/Mesh.h"
#include "Object/Material.h"

namespace idiophone {

/// The mesh is the mid-surface. Its two copies lie at ± t/√12 along the vertex normals, each with
/// half of the mass and stiffness. So both the membrane stiffness Y t and the bending stiffness Y
/// t³/12 are right. Each triangle of a layer has three springs that act on all its corners: one
/// against change of area, two against change of shape. Together they are the plane-stress triangle
/// of the material's ν. For equilateral triangles and ν = 1/3 they equal springs along the edges.
///
/// At every vertex, a post joins the layers. At every edge, a pair of crossed braces resists
/// transverse shear with G = Y/(2(1+ν)) and Cowper's shear coefficient. They act on the difference
/// of their elongations. Their sum is free, because it would stiffen the membrane.
///
/// Rows 6v … 6v+2 are the displacement of vertex v in the upper layer (along the normal), rows 6v+3
/// … 6v+5 in the lower. The mesh is as repairMesh leaves it.
VibrationModel twoLayerShell(const Mesh& mesh, const Material& material, double thicknessMetres);

/// Returns half the distance of the two layers: t/√12.
double layerOffsetMetres(double thicknessMetres);

/// Returns [3N × modes] the displacement of the mid-surface, the mean of both layers, for shapes
/// [6N × modes] of the model. Rows 3v … 3v+2 belong to vertex v.
Eigen::MatrixXd midSurfaceShapes(const Eigen::MatrixXd& shapes);

} // namespace idiophone
