#include "Analysis/ClosedSurface.h"

#include "Geometry/ParametricMesh.h"

#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Returns a [3N×1] shape that moves every vertex by the same vector.
Eigen::MatrixXd translation(const Mesh& mesh, const Eigen::Vector3d& by) {
    return by.replicate(mesh.vertexCount(), 1);
}

} // namespace

TEST_CASE("A sheet is closed by two faces and a rim and encloses its volume") {
    const Mesh sheet = sheetMesh(0.3, 0.2, 200);
    const auto closed = closedSurface(sheet, 0.003);
    REQUIRE(closed);
    CHECK(isClosed(uniqueEdges(closed->mesh)));
    CHECK_THAT(signedVolumeM3(closed->mesh), WithinRel(0.3 * 0.2 * 0.003, 1e-9));
    const Eigen::MatrixXd up = closed->normalShapes(translation(sheet, {0, 0, 1}));
    CHECK_THAT(up.maxCoeff(), WithinAbs(1, 1e-12));
    CHECK_THAT(up.minCoeff(), WithinAbs(-1, 1e-12));
    CHECK_THAT(up.col(0).dot(faceAreas(closed->mesh)), WithinAbs(0, 1e-12));
}

TEST_CASE("A closed body stays unchanged beside a sheet that is closed") {
    const Mesh ball = icosphereMesh(0.1, 2), sheet = sheetMesh(0.3, 0.2, 100);
    Mesh both{Eigen::MatrixXd(ball.vertexCount() + sheet.vertexCount(), 3),
              Eigen::MatrixXi(ball.faceCount() + sheet.faceCount(), 3)};
    both.vertices << ball.vertices, sheet.vertices.rowwise() + Eigen::RowVector3d(0, 0, 1);
    both.faces << ball.faces, sheet.faces.array() + static_cast<int>(ball.vertexCount());
    const auto closed = closedSurface(both, 0.002);
    REQUIRE(closed);
    CHECK(isClosed(uniqueEdges(closed->mesh)));
    CHECK_THAT(signedVolumeM3(closed->mesh),
               WithinRel(signedVolumeM3(ball) + 0.3 * 0.2 * 0.002, 1e-9));
}

TEST_CASE("A closed body needs no thickness, but an open one does") {
    CHECK(closedSurface(icosphereMesh(0.1, 1), 0));
    CHECK_FALSE(closedSurface(sheetMesh(0.3, 0.2, 100), 0));
}

TEST_CASE("Faces without area are dropped") {
    Mesh ball = icosphereMesh(0.1, 1);
    ball.faces.conservativeResize(ball.faceCount() + 2, 3);
    ball.faces.bottomRows(2) << 0, 0, 1, 1, 0, 0;
    const auto closed = closedSurface(ball, 0.001);
    REQUIRE(closed);
    CHECK(faceAreas(closed->mesh).minCoeff() > 0);
}

TEST_CASE("Split and remeshed surfaces keep their shape and their motion") {
    const Mesh ball = icosphereMesh(0.1, 3);
    const auto closed = closedSurface(ball, 0);
    REQUIRE(closed);
    const auto finer = withFacesSplit(*closed);
    CHECK(finer.mesh.faceCount() == 4 * ball.faceCount());
    CHECK_THAT(signedVolumeM3(finer.mesh), WithinRel(signedVolumeM3(ball), 1e-9));
    const auto coarser = remeshed(*closed, 0.04);
    REQUIRE(coarser);
    CHECK(coarser->mesh.faceCount() < ball.faceCount() / 2);
    for (const auto* surface : {&finer, &*coarser}) {
        // The motion is (1 + z) along x.
        Eigen::MatrixXd shape = translation(ball, {1, 0, 0});
        for (Eigen::Index vertex = 0; vertex < ball.vertexCount(); ++vertex)
            shape(3 * vertex) += ball.vertices(vertex, 2);
        const Eigen::VectorXd flows = surface->normalShapes(shape);
        for (Eigen::Index face = 0; face < surface->mesh.faceCount(); ++face) {
            const auto corner = [&](int k) {
                return Eigen::RowVector3d(surface->mesh.vertices.row(surface->mesh.faces(face, k)));
            };
            const double meanHeight = (corner(0) + corner(1) + corner(2)).z() / 3;
            const Eigen::RowVector3d normal =
                (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
            CHECK_THAT(flows(face), WithinAbs((1 + meanHeight) * normal.x(), 1e-3));
        }
    }
}
