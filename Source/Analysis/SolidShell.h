// A wall about a middle surface as finite elements, one layer of prisms cut into tetrahedra: for
// thin bodies whose thickness varies, such as bells. TwoLayerShell serves where it does not.
#pragma once

#include "Analysis/BodyModel.h"
#include "Analysis/ElasticLaw.h"
#include "Geometry/Mesh.h"

namespace idiophone {

/// The wall reaches half of its thickness [N] in metres, > 0, to either side of the middle surface,
/// an oriented manifold of N vertices, open or closed. Its thickness is nowhere as much as the
/// radius of curvature or the triangles' edges. Each triangle becomes three quadratic tetrahedra of
/// straight edges.
///
/// The body's surface is the wall's, closed: vertex v lies on the side the faces look to, vertex N
/// + v opposite.
BodyModel
solidShell(const Mesh& middle, const Eigen::VectorXd& thicknessMetres, const Material& material);

} // namespace idiophone
