// Builds finite elements for a wall around a middle surface: one layer of prisms, cut into
// tetrahedra. It serves thin bodies of varying thickness, such as bells. TwoLayerShell serves
// constant thickness.
#pragma once

#include "Analysis/BodyModel.h"
#include "Analysis/ElasticLaw.h"
#include "Mesh/Mesh.h"

namespace idiophone {

/// The wall extends half of its thickness [N] in metres, > 0, to both sides of the middle surface.
/// It is an oriented manifold of N vertices, open or closed. The thickness is everywhere less than
/// the radius of curvature and the triangles' edges. Each triangle becomes three quadratic
/// tetrahedra with straight edges.
///
/// The body's surface is that of the wall, closed. Vertex v lies on the outer side of the faces,
/// vertex N + v opposite.
BodyModel
solidShell(const Mesh& middle, const Eigen::VectorXd& thicknessMetres, const Material& material);

} // namespace idiophone
