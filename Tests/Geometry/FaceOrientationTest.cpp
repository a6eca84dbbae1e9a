#include "Geometry/FaceOrientation.h"

#include "Geometry/ParametricMesh.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

TEST_CASE("A cancelled search for hollows turns no face") {
    const Mesh outer = icosphereMesh(1, 2), inner = icosphereMesh(0.5, 2);
    const auto vertices = outer.vertexCount(), faces = outer.faceCount();
    Mesh both{Eigen::MatrixXd(2 * vertices, 3), Eigen::MatrixXi(2 * faces, 3)};
    both.vertices << outer.vertices, inner.vertices;
    both.faces << outer.faces, inner.faces.array() + static_cast<int>(vertices);
    const auto pairing = pairEdges(both);
    const std::atomic<bool> goesOn = false, cancelled = true;

    auto turned = both;
    auto turnedPairing = pairing;
    const auto done = orientFaces(turned, turnedPairing, &goesOn);
    CHECK_FALSE(done.isTangled);
    CHECK(done.hollows == 1);
    CHECK(done.flippedFaces == faces);

    auto left = both;
    auto leftPairing = pairing;
    const auto givenUp = orientFaces(left, leftPairing, &cancelled);
    CHECK(givenUp.isTangled);
    CHECK(givenUp.hollows == 0);
    CHECK(givenUp.flippedFaces == 0);
    CHECK(left.faces == both.faces);
}
