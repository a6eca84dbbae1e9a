// CGAL's tree of points, over numbered vertices. Internal to Geometry.
#pragma once

#include "Mesh/Mesh.h"

#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>
#include <utility>

namespace idiophone {

using VertexTreeKernel = CGAL::Simple_cartesian<double>;
using NumberedPoint = std::pair<VertexTreeKernel::Point_3, int>;
using VertexTreeTraits =
    CGAL::Search_traits_adapter<NumberedPoint,
                                CGAL::First_of_pair_property_map<NumberedPoint>,
                                CGAL::Search_traits_3<VertexTreeKernel>>;
using VertexTree = CGAL::Kd_tree<VertexTreeTraits>;

inline NumberedPoint numberedPoint(const Eigen::MatrixXd& vertices, int vertex) {
    return {{vertices(vertex, 0), vertices(vertex, 1), vertices(vertex, 2)}, vertex};
}

} // namespace idiophone
