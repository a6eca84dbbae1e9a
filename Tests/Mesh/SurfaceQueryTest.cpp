#include "Mesh/SurfaceQuery.h"

#include "Geometry/ParametricMesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <limits>
#include <random>

using namespace idiophone;

namespace {

Eigen::Vector3d corner(const Mesh& mesh, Eigen::Index face, int k) {
    return mesh.vertices.row(mesh.faces(face, k));
}

/// Tries the triangle's inside, edges and corners.
double distanceTo(const Mesh& mesh, Eigen::Index face, const Eigen::Vector3d& p) {
    double best = 1e300;
    const Eigen::Vector3d a = corner(mesh, face, 0), u = corner(mesh, face, 1) - a,
                          v = corner(mesh, face, 2) - a;
    Eigen::Matrix<double, 3, 2> basis;
    basis << u, v;
    const Eigen::Vector2d st = (basis.transpose() * basis).inverse() * basis.transpose() * (p - a);
    if (st.minCoeff() >= 0 && st.sum() <= 1)
        best = (a + basis * st - p).norm();
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d from = corner(mesh, face, k),
                              along = corner(mesh, face, (k + 1) % 3) - from;
        const double t = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        best = std::min(best, (from + t * along - p).norm());
    }
    return best;
}

/// Returns the distance at which the ray meets the triangle; negative if it misses.
double hitDistance(const Mesh& mesh,
                   Eigen::Index face,
                   const Eigen::Vector3d& origin,
                   const Eigen::Vector3d& direction) {
    Eigen::Matrix3d system;
    const Eigen::Vector3d a = corner(mesh, face, 0);
    system << corner(mesh, face, 1) - a, corner(mesh, face, 2) - a, -direction;
    const Eigen::Vector3d x = system.fullPivLu().solve(origin - a);
    const bool inside = x(0) >= 0 && x(1) >= 0 && x(0) + x(1) <= 1 && x(2) >= 0;
    return inside ? x(2) * direction.norm() : -1;
}

/// Returns all faces between three clusters of vertices in a sloping plane. Their boxes nearly
/// coincide.
Mesh heapedFaces(int verticesOfHeap) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> spread(-0.001, 0.001);
    const Eigen::Vector2d heaps[]{{0, 0}, {1, 0}, {0, 1}};
    Mesh mesh{Eigen::MatrixXd(3 * verticesOfHeap, 3),
              Eigen::MatrixXi(verticesOfHeap * verticesOfHeap * verticesOfHeap, 3)};
    for (int vertex = 0; vertex < mesh.vertices.rows(); ++vertex) {
        const auto& heap = heaps[vertex / verticesOfHeap];
        const double x = heap.x() + spread(random), y = heap.y() + spread(random);
        mesh.vertices.row(vertex) << x, y, x + y;
    }
    for (int face = 0; face < mesh.faces.rows(); ++face)
        mesh.faces.row(face) << face % verticesOfHeap,
            verticesOfHeap + face / verticesOfHeap % verticesOfHeap,
            2 * verticesOfHeap + face / verticesOfHeap / verticesOfHeap;
    return mesh;
}

} // namespace

TEST_CASE("Nearest points and first hits match brute force for any mesh size") {
    const double size = GENERATE(1e-3, 1.0, 100.0); // triangles from 1e-10 to 1 m²
    const SurfaceQuery query(torusMesh(size, 0.4 * size, 30, 14));
    const auto& mesh = query.mesh();
    std::mt19937 random(6);
    std::uniform_real_distribution<double> number(-1.5 * size, 1.5 * size);
    int hits = 0;
    for (int round = 0; round < 300; ++round) {
        const Eigen::Vector3d p(number(random), number(random), number(random));
        const Eigen::Vector3d d(number(random), number(random), number(random));
        double nearest = 1e300, first = 1e300;
        for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
            nearest = std::min(nearest, distanceTo(mesh, face, p));
            if (const double t = hitDistance(mesh, face, p, d); t >= 0)
                first = std::min(first, t);
        }
        const auto found = query.nearestPoint(p);
        REQUIRE(std::abs(found.distanceMetres - nearest) <= 1e-9 * size);
        REQUIRE(std::abs((found.pointMetres - p).norm() - nearest) <= 1e-9 * size);
        REQUIRE(std::abs(found.barycentric.sum() - 1) < 1e-12);
        Eigen::Vector3d rebuilt = Eigen::Vector3d::Zero();
        for (int k = 0; k < 3; ++k)
            rebuilt += found.barycentric(k) * corner(mesh, found.face, k);
        REQUIRE((rebuilt - found.pointMetres).norm() <= 1e-9 * size);

        const auto hit = query.firstHit(p, d);
        REQUIRE(hit.has_value() == (first < 1e299));
        if (hit) {
            ++hits;
            REQUIRE(std::abs(hit->distanceMetres - first) <= 1e-9 * size);
            REQUIRE(std::abs(hit->normal.norm() - 1) < 1e-12);
        }
    }
    CHECK(hits > 50);
}

TEST_CASE("A ray down onto a flat sheet hits everywhere, also at edges and vertices") {
    const double length = 0.39, width = 0.04;
    const SurfaceQuery query(sheetMesh(length, width, 900));
    for (int i = 0; i <= 40; ++i)
        for (int j = 0; j <= 8; ++j) {
            const Eigen::Vector3d above((i / 40.0 - 0.5) * length * (1 - 1e-9),
                                        (j / 8.0 - 0.5) * width * (1 - 1e-9), 0.3);
            const auto hit = query.firstHit(above, {0, 0, -2});
            REQUIRE(hit);
            REQUIRE(std::abs(hit->distanceMetres - 0.3) < 1e-12);
        }
    for (Eigen::Index v = 0; v < query.mesh().vertexCount(); ++v) {
        const Eigen::Vector3d at = query.mesh().vertices.row(v);
        REQUIRE(nearestVertex(query.mesh(), at.transpose() + Eigen::RowVector3d(0, 0, 0.001)) == v);
        REQUIRE(query.nearestPoint(at).distanceMetres < 1e-12);
    }
    CHECK_FALSE(query.firstHit({0, 0, 0.3}, {0, 0, 1}));
    CHECK_FALSE(query.firstHit({1, 0, 0.3}, {0, 0, -1}));
}

TEST_CASE("A moved query still works") {
    SurfaceQuery first(icosphereMesh(1, 2));
    SurfaceQuery second = std::move(first);
    CHECK(second.firstHit({3, 0.1, 0.1}, {-1, 0, 0}));
}

TEST_CASE("A query from a point too far away returns a face at infinite distance") {
    const SurfaceQuery query(icosphereMesh(1, 1));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Eigen::Vector3d& point :
         {Eigen::Vector3d(nan, 0, 0), Eigen::Vector3d(1e200, 0, 0)}) {
        const auto nearest = query.nearestPoint(point);
        CHECK(nearest.face == 0);
        CHECK(nearest.barycentric.allFinite());
        CHECK(nearest.pointMetres.allFinite());
        CHECK(std::isinf(nearest.distanceMetres));
    }
}

TEST_CASE("A ray passes through all faces in its path, within its box limit") {
    const SurfaceQuery query(icosphereMesh(1, 3));
    const Eigen::Vector3d from(0.013, 0.021, -3), up(0, 0, 2);
    std::int64_t boxes = 1000;
    const auto passages = query.passages(from, up, boxes);
    REQUIRE(passages);
    REQUIRE(passages->size() == 2);
    const double first = query.firstHit(from, up)->distanceMetres / 2;
    CHECK(std::abs(passages->front() - first) < 1e-12);
    CHECK(std::abs(passages->back() - 2) < 0.01);
    CHECK(boxes > 0);
    CHECK(boxes < 1000);
    CHECK(query.passages({5, 0, 0}, up, boxes)->empty());
    boxes = 3;
    CHECK_FALSE(query.passages(from, up, boxes));
}

TEST_CASE("If many faces overlap, a query ends with the best face found within its limit") {
    const SurfaceQuery query(heapedFaces(40));
    const Eigen::Vector3d above(0.3, 0.3, 5), down(0, 0, -1);
    constexpr std::int64_t plenty = 1'000'000;
    std::int64_t forPoint = plenty, forRay = plenty;
    const auto nearest = query.nearestPoint(above, forPoint);
    const auto hit = query.firstHit(above, down, forRay);
    REQUIRE(hit);
    CHECK(plenty - forPoint > query.boxesForPoint); // more than the default limit
    CHECK(plenty - forRay > 50'000);

    const auto soon = query.nearestPoint(above);
    CHECK(soon.distanceMetres >= nearest.distanceMetres);
    CHECK(soon.distanceMetres < 1.01 * nearest.distanceMetres);
    std::int64_t few = 100;
    const auto some = query.firstHit(above, down, few);
    CHECK(few == 0);
    REQUIRE(some);
    CHECK(std::abs(some->distanceMetres - hit->distanceMetres) < 0.01);
    few = 0;
    CHECK_FALSE(query.firstHit(above, down, few));
    CHECK(std::isinf(query.nearestPoint(above, few).distanceMetres));
    CHECK(few == 0);
}
