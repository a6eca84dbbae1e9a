#include "Mesh/ObjectMesh.h"

#include "Geometry/ParametricMesh.h"

#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;

TEST_CASE("The corners of a box have the normals of its sides") {
    const auto box = boxMesh({0.3, 0.2, 0.1}, {3, 2, 2});
    const auto normals = cornerNormals(box);
    REQUIRE(normals.rows() == 3 * box.faceCount());
    for (Eigen::Index corner = 0; corner < normals.rows(); ++corner) {
        const auto& face = box.faces.row(corner / 3);
        const Eigen::RowVector3d a = box.vertices.row(face(0));
        const Eigen::RowVector3d u = box.vertices.row(face(1)) - a;
        const Eigen::RowVector3d v = box.vertices.row(face(2)) - a;
        CHECK((normals.row(corner) - u.cross(v).normalized()).norm() < 1e-9);
    }
}

TEST_CASE("The corner normals of a ball point outward") {
    const auto ball = icosphereMesh(2, 4);
    const auto normals = cornerNormals(ball);
    for (Eigen::Index corner = 0; corner < normals.rows(); ++corner) {
        const Eigen::RowVector3d place = ball.vertices.row(ball.faces(corner / 3, corner % 3));
        CHECK(normals.row(corner).dot(place.normalized()) > 0.999);
    }
}

TEST_CASE("Corner normals are fast and right for 200,000 faces around one vertex") {
    constexpr int sides = 200'000;
    const double height = GENERATE(0.1, 3.0);
    Mesh cone{Eigen::MatrixXd(sides + 1, 3), Eigen::MatrixXi(sides, 3)};
    cone.vertices.row(sides) << 0, 0, height;
    for (int side = 0; side < sides; ++side) {
        const double angle = 2 * std::numbers::pi * side / sides;
        cone.vertices.row(side) << std::cos(angle), std::sin(angle), 0;
        cone.faces.row(side) << sides, side, (side + 1) % sides;
    }
    const auto normals = cornerNormals(cone);
    // A flat cone is smooth at its tip, but a steep one is not.
    CHECK((normals(0, 2) > 0.9999) == (height < 1));
    CHECK(normals.rowwise().norm().minCoeff() > 0.999);
    for (const int side : {0, 77, sides / 2}) {
        const Eigen::RowVector3d rim = cone.vertices.row(side);
        CHECK(
            std::abs(
                normals.row(3 * side + 1)
                    .dot(Eigen::RowVector3d(height * rim.x(), height * rim.y(), 1).normalized())) >
            0.999);
    }
}

TEST_CASE("A face that occurs many times keeps its own normal") {
    Mesh mesh{Eigen::MatrixXd{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Eigen::MatrixXi(200'000, 3)};
    mesh.faces.rowwise() = Eigen::RowVector3i(0, 1, 2);
    mesh.faces.row(5) << 0, 2, 1;
    const auto normals = cornerNormals(mesh);
    CHECK((normals.rowwise() - Eigen::RowVector3d(0, 0, 1)).rowwise().norm().maxCoeff() == 2);
    CHECK(normals(15, 2) == -1);
}

TEST_CASE("A face without area has finite corner normals") {
    const Mesh mesh{Eigen::MatrixXd{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}},
                    Eigen::MatrixXi{{0, 1, 2}, {0, 1, 3}}};
    const auto normals = cornerNormals(mesh);
    CHECK(normals.topRows(3).allFinite());
    CHECK((normals.bottomRows(3).rowwise() - Eigen::RowVector3d(0, 0, 1)).norm() < 1e-9);
}
