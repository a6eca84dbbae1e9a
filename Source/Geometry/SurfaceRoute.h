// A way over a surface from one place to another.
#pragma once

#include "Geometry/Mesh.h"

#include <vector>

namespace idiophone {

/// Along the edges of faces that face within 60° of a unit vector, or of all where these do not
/// join, from the vertex of such faces nearest to one point to that nearest to another: the
/// shortest such way, with its corners rounded off. Empty where nothing joins them. The mesh has a
/// face, and its indices are valid.
std::vector<Eigen::Vector3d> surfaceRoute(const Mesh& mesh,
                                          const Eigen::Vector3d& from,
                                          const Eigen::Vector3d& to,
                                          const Eigen::Vector3d& facing);

} // namespace idiophone
