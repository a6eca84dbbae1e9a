#include "Geometry/TouchingBoxes.h"

#include "Geometry/ParametricMesh.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

TEST_CASE("Faces in one place touch each other, and those beside each other their neighbours") {
    Mesh same{Eigen::MatrixXd{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Eigen::MatrixXi(10, 3)};
    same.faces.rowwise() = Eigen::RowVector3i(0, 1, 2);
    CHECK(touchingBoxes(same, 45) == 45);
    CHECK_FALSE(touchingBoxes(same, 44));
    Mesh row{Eigen::MatrixXd(30, 3), Eigen::MatrixXi(10, 3)};
    for (int face = 0; face < 10; ++face)
        for (int corner = 0; corner < 3; ++corner) {
            row.vertices.row(3 * face + corner) << face + (corner == 1), corner == 2, 0;
            row.faces(face, corner) = 3 * face + corner;
        }
    CHECK(touchingBoxes(row, 1000) == 9);
    CHECK(touchingBoxes({row.vertices, Eigen::MatrixXi(0, 3)}, 0) == 0);
}

TEST_CASE("A sound mesh has some ten neighbours a face, and a heap is known for one soon") {
    const auto ball = icosphereMesh(1, 6); // of 81920 faces
    const auto touching = touchingBoxes(ball, 5'000'000);
    REQUIRE(touching);
    CHECK(*touching > 6 * static_cast<std::size_t>(ball.faceCount()));
    CHECK(*touching < 20 * static_cast<std::size_t>(ball.faceCount()));
    Mesh heap{Eigen::MatrixXd{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Eigen::MatrixXi(1'000'000, 3)};
    heap.faces.rowwise() = Eigen::RowVector3i(0, 1, 2);
    CHECK_FALSE(touchingBoxes(heap, 5'000'000));
}
