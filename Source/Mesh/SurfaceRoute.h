// SPDX-License-Identifier: Apache-2.0
// Finds a path over a surface from one place to another.
#pragma once

#include "Mesh/Mesh.h"

#include <vector>

namespace idiophone {

/// Returns the shortest path along edges between the vertices nearest to `from` and `to`, with
/// rounded corners. Uses only faces within 60° of the unit vector `facing`; if these do not
/// connect, all faces. Empty if nothing connects the vertices. The mesh must have a face and valid
/// indices.
std::vector<Eigen::Vector3d> surfaceRoute(const Mesh& mesh,
                                          const Eigen::Vector3d& from,
                                          const Eigen::Vector3d& to,
                                          const Eigen::Vector3d& facing);

} // namespace idiophone
