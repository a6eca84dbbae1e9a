#include "Geometry/ObjectMesh.h"

#include "Geometry/ParametricMesh.h"

#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>

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

TEST_CASE("A ball's corners look outward as the ball does") {
    const auto ball = icosphereMesh(2, 4);
    const auto normals = cornerNormals(ball);
    for (Eigen::Index corner = 0; corner < normals.rows(); ++corner) {
        const Eigen::RowVector3d place = ball.vertices.row(ball.faces(corner / 3, corner % 3));
        CHECK(normals.row(corner).dot(place.normalized()) > 0.999);
    }
}

TEST_CASE("A face without area has no normal") {
    const Mesh mesh{Eigen::MatrixXd{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}},
                    Eigen::MatrixXi{{0, 1, 2}, {0, 1, 3}}};
    const auto normals = cornerNormals(mesh);
    CHECK(normals.topRows(3).allFinite());
    CHECK((normals.bottomRows(3).rowwise() - Eigen::RowVector3d(0, 0, 1)).norm() < 1e-9);
}
