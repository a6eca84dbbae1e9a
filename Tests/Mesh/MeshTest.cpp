#include "Mesh/Mesh.h"

#include "Geometry/ParametricMesh.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using Catch::Matchers::WithinRel;

TEST_CASE("A box has the area and volume of its sides") {
    const auto box = boxMesh({0.4, 0.05, 0.02}, {20, 4, 2});
    CHECK_THAT(faceAreas(box).sum(), WithinRel(2 * (0.4 * 0.05 + 0.4 * 0.02 + 0.05 * 0.02), 1e-12));
    CHECK_THAT(signedVolumeM3(box), WithinRel(0.4 * 0.05 * 0.02, 1e-12));
    CHECK_THAT(vertexAreas(box).sum(), WithinRel(faceAreas(box).sum(), 1e-12));
    CHECK_THAT(boundingDiagonalMetres(box), WithinRel(std::hypot(0.4, 0.05, 0.02), 1e-12));
}

TEST_CASE("The volume keeps its precision far from the origin") {
    auto sphere = icosphereMesh(0.1, 3);
    const double volume = signedVolumeM3(sphere);
    sphere.vertices.rowwise() += Eigen::RowVector3d(1e4, -2e4, 3e4);
    CHECK_THAT(signedVolumeM3(sphere), WithinRel(volume, 1e-8));
}

TEST_CASE("The vertex normals of a sphere point away from its centre") {
    const auto sphere = icosphereMesh(2, 3);
    const auto normals = vertexNormals(sphere);
    for (Eigen::Index v = 0; v < sphere.vertexCount(); ++v)
        REQUIRE(normals.row(v).dot(sphere.vertices.row(v)) / 2 > 0.999);
}

TEST_CASE("Edges list their face counts and areas, and show whether the mesh is closed") {
    const auto sphere = icosphereMesh(1, 2);
    const auto edges = uniqueEdges(sphere);
    CHECK(static_cast<Eigen::Index>(edges.size()) == 3 * sphere.vertexCount() - 6);
    CHECK(isClosed(edges));
    double area = 0;
    for (const auto& edge : edges)
        area += edge.adjacentAreaM2;
    CHECK_THAT(area, WithinRel(3 * faceAreas(sphere).sum(), 1e-12));
    CHECK_FALSE(isClosed(uniqueEdges(discMesh(1, 3))));
}

TEST_CASE("Components are numbered in the order of their first vertices") {
    const auto one = icosphereMesh(1, 0);
    Mesh two{Eigen::MatrixXd(25, 3), Eigen::MatrixXi(40, 3)};
    two.vertices << one.vertices, one.vertices.array() + 5, Eigen::RowVector3d::Zero();
    two.faces << one.faces, one.faces.array() + 12;
    const auto components = connectedComponents(two);
    CHECK(components.count == 3); // two spheres and a single vertex
    CHECK(components.componentOfVertex[0] == 0);
    CHECK(components.componentOfVertex[12] == 1);
    CHECK(components.componentOfVertex[24] == 2);
}
