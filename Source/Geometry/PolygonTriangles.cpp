#include "Geometry/PolygonTriangles.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace idiophone {
namespace {

using Triangles = std::vector<std::array<int, 3>>;
using PlaneKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// A face knows on which side of the outline it lies.
enum class Side { unknown, outside, inside };
using OutlineVertex = CGAL::Triangulation_vertex_base_with_info_2<int, PlaneKernel>;
using OutlineFace = CGAL::Triangulation_face_base_with_info_2<
    Side,
    PlaneKernel,
    CGAL::Constrained_triangulation_face_base_2<PlaneKernel>>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<
    PlaneKernel,
    CGAL::Triangulation_data_structure_2<OutlineVertex, OutlineFace>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;
/// Counts how often the outline runs along each edge.
using Outline = CGAL::Constrained_triangulation_plus_2<Delaunay>;

Triangles fan(int corners) {
    Triangles triangles;
    for (int corner = 2; corner < corners; ++corner)
        triangles.push_back({0, corner - 1, corner});
    return triangles;
}

/// Twice the polygon's area vector.
Eigen::RowVector3d doubleAreaOf(const Eigen::MatrixX3d& fromFirst) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (Eigen::Index corner = 2; corner < fromFirst.rows(); ++corner)
        sum += fromFirst.row(corner - 1).cross(fromFirst.row(corner));
    return sum;
}

/// A triangle counts as flat as in dropDegenerateFaces.
bool isFlat(const Eigen::RowVector3d& u, const Eigen::RowVector3d& v, double doubleArea) {
    return doubleArea <=
           1e-10 * std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
}

bool fanLiesInside(const Eigen::MatrixX3d& fromFirst, const Eigen::RowVector3d& normal) {
    double turned = 0; // a fan of more than a full turn would overlap
    for (Eigen::Index corner = 2; corner < fromFirst.rows(); ++corner) {
        const Eigen::RowVector3d u = fromFirst.row(corner - 1), v = fromFirst.row(corner);
        const double doubleArea = u.cross(v).dot(normal);
        if (isFlat(u, v, doubleArea))
            return false;
        turned += std::atan2(doubleArea, u.dot(v));
    }
    return turned < 2 * std::numbers::pi;
}

bool isOnLine(const Eigen::MatrixX3d& fromFirst) {
    for (Eigen::Index corner = 2; corner < fromFirst.rows(); ++corner) {
        const Eigen::RowVector3d u = fromFirst.row(corner - 1), v = fromFirst.row(corner);
        if (!isFlat(u, v, u.cross(v).norm()))
            return false;
    }
    return true;
}

/// Returns the corners as seen along the normal, drawn on the plane of two axes: the coordinates of
/// polygons in that plane stay exact.
std::vector<PlaneKernel::Point_2> drawn(const Eigen::MatrixX3d& fromFirst,
                                        const Eigen::RowVector3d& normal) {
    Eigen::Index dropped = 0;
    normal.cwiseAbs().maxCoeff(&dropped);
    Eigen::Index first = (dropped + 1) % 3, second = (dropped + 2) % 3;
    if (normal(dropped) < 0)
        std::swap(first, second);
    std::vector<PlaneKernel::Point_2> points;
    for (const auto& corner : fromFirst.rowwise()) {
        const double along = corner(dropped) / normal(dropped);
        points.emplace_back(corner(first) - along * normal(first),
                            corner(second) - along * normal(second));
    }
    return points;
}

/// Marks each face of the triangulation: the side changes where the outline runs along an edge an
/// odd number of times.
void markSides(Outline& outline) {
    for (const auto face : outline.all_face_handles())
        face->info() = Side::unknown;
    std::vector<Outline::Face_handle> reached{outline.infinite_face()};
    reached.front()->info() = Side::outside;
    while (!reached.empty()) {
        const auto face = reached.back();
        reached.pop_back();
        for (int i = 0; i < 3; ++i) {
            const auto next = face->neighbor(i);
            if (next->info() != Side::unknown)
                continue;
            const bool changes = outline.is_constrained({face, i}) &&
                                 outline.number_of_enclosing_constraints(
                                     face->vertex(Outline::cw(i)), face->vertex(Outline::ccw(i))) %
                                         2 ==
                                     1;
            next->info() =
                changes == (face->info() == Side::outside) ? Side::inside : Side::outside;
            reached.push_back(next);
        }
    }
}

/// Returns nothing if the outline crosses itself in the plane, or different corners meet there.
std::optional<Triangles> filled(const Eigen::MatrixX3d& fromFirst,
                                const Eigen::RowVector3d& normal,
                                double doubleAreaAcross) {
    const auto points = drawn(fromFirst, normal);
    Outline outline;
    std::vector<Outline::Vertex_handle> corners;
    for (int corner = 0; corner < static_cast<int>(points.size()); ++corner) {
        const auto before = outline.number_of_vertices();
        corners.push_back(outline.insert(points[static_cast<std::size_t>(corner)]));
        if (outline.number_of_vertices() > before)
            corners.back()->info() = corner;
        else if (fromFirst.row(corners.back()->info()) != fromFirst.row(corner))
            return std::nullopt;
    }
    try {
        for (std::size_t corner = 0; corner < corners.size(); ++corner)
            if (const auto next = corners[(corner + 1) % corners.size()]; next != corners[corner])
                outline.insert_constraint(corners[corner], next);
    } catch (const Outline::Intersection_of_constraints_exception&) {
        return std::nullopt;
    }
    markSides(outline);
    Triangles triangles;
    double doubleArea = 0;
    for (const auto face : outline.finite_face_handles())
        if (face->info() == Side::inside) {
            triangles.push_back(
                {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
            doubleArea += 2 * outline.triangle(face).area();
        }
    // An outline that goes twice around, or the wrong way around a part of itself, fills another
    // area.
    const double wanted = doubleAreaAcross / normal.cwiseAbs().maxCoeff();
    return std::abs(doubleArea - wanted) <= 1e-6 * wanted ? std::optional(std::move(triangles))
                                                          : std::nullopt;
}

} // namespace

PolygonTriangles trianglesOf(const Eigen::MatrixX3d& polygon) {
    PolygonTriangles result;
    const Eigen::MatrixX3d fromFirst = polygon.rowwise() - polygon.row(0);
    const Eigen::RowVector3d areaVector = doubleAreaOf(fromFirst);
    const double doubleArea = areaVector.norm();
    const Eigen::RowVector3d normal = areaVector / doubleArea;
    result.corners = fan(static_cast<int>(polygon.rows()));
    if (polygon.rows() == 3 || isOnLine(fromFirst) ||
        (doubleArea > 0 && fanLiesInside(fromFirst, normal)))
        return result;
    const double extent = fromFirst.rowwise().norm().maxCoeff();
    auto triangles =
        doubleArea > 1e-10 * extent * extent ? filled(fromFirst, normal, doubleArea) : std::nullopt;
    result.isGuess = !triangles;
    if (triangles)
        result.corners = std::move(*triangles);
    return result;
}

} // namespace idiophone
