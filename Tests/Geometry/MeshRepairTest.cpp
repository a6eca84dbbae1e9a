#include "Geometry/MeshRepair.h"

#include "Geometry/ParametricMesh.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <limits>
#include <random>

using namespace idiophone;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Every face with vertices of its own, as STL files have them.
Mesh soupOf(const Mesh& mesh) {
    Mesh soup{Eigen::MatrixXd(3 * mesh.faceCount(), 3), mesh.faces};
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 0; corner < 3; ++corner) {
            soup.vertices.row(3 * face + corner) = mesh.vertices.row(mesh.faces(face, corner));
            soup.faces(face, corner) = static_cast<int>(3 * face + corner);
        }
    return soup;
}

Mesh joined(const Mesh& a, const Mesh& b) {
    Mesh both{Eigen::MatrixXd(a.vertexCount() + b.vertexCount(), 3),
              Eigen::MatrixXi(a.faceCount() + b.faceCount(), 3)};
    both.vertices << a.vertices, b.vertices;
    both.faces << a.faces, b.faces.array() + static_cast<int>(a.vertexCount());
    return both;
}

} // namespace

TEST_CASE("A sound mesh comes out of repair as it went in") {
    for (const auto& mesh : {icosphereMesh(0.1, 3), sheetMesh(0.4, 0.05, 500)}) {
        const auto repaired = repairMesh(mesh);
        REQUIRE(repaired);
        CHECK(repaired->mesh.vertices == mesh.vertices);
        CHECK(repaired->mesh.faces == mesh.faces);
        CHECK_FALSE(repaired->report.changedAnything());
    }
}

TEST_CASE("A soup of triangles is welded into the closed surface that it depicts") {
    const auto sphere = icosphereMesh(0.1, 3);
    auto soup = soupOf(sphere);
    std::mt19937 random(3);
    for (double& coordinate : soup.vertices.reshaped()) // noise far below the tolerance
        coordinate += 1e-10 * (static_cast<double>(random() % 2001) / 1000 - 1) * 0.1;
    const auto repaired = repairMesh(soup);
    REQUIRE(repaired);
    CHECK(repaired->mesh.vertexCount() == sphere.vertexCount());
    CHECK(isClosed(uniqueEdges(repaired->mesh)));
    CHECK(repaired->report.weldedVertices == soup.vertexCount() - sphere.vertexCount());
    CHECK_THAT(repaired->report.text(), ContainsSubstring("Welded"));
    for (const int vertex : repaired->vertexOfInput)
        REQUIRE((vertex >= 0 && vertex < sphere.vertexCount()));
}

TEST_CASE("Degenerate and duplicate faces and unreferenced vertices are dropped and counted") {
    auto mesh = icosphereMesh(1, 1);
    const auto faces = mesh.faceCount(), vertices = mesh.vertexCount();
    mesh.vertices.conservativeResize(vertices + 2, Eigen::NoChange);
    mesh.vertices.bottomRows(2) << 0, 0, 0, 9, 9, 9;
    mesh.faces.conservativeResize(faces + 3, Eigen::NoChange);
    mesh.faces.row(faces) << 0, 1, 1;
    mesh.faces.row(faces + 1) << mesh.faces(5, 1), mesh.faces(5, 0), mesh.faces(5, 2);
    mesh.faces.row(faces + 2) = mesh.faces.row(7);
    const auto repaired = repairMesh(mesh);
    REQUIRE(repaired);
    CHECK(repaired->report.degenerateFaces == 1);
    CHECK(repaired->report.duplicateFaces == 2);
    CHECK(repaired->report.unreferencedVertices == 2);
    CHECK(repaired->mesh.faceCount() == faces);
    CHECK(repaired->mesh.vertexCount() == vertices);
    CHECK(repaired->vertexOfInput[vertices] == -1);
}

TEST_CASE("Faces turned at random are oriented outward again") {
    auto mesh = icosphereMesh(1, 3);
    std::mt19937 random(4);
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        if (random() % 2 == 0)
            std::swap(mesh.faces(face, 0), mesh.faces(face, 1));
    const auto repaired = repairMesh(mesh);
    REQUIRE(repaired);
    CHECK(repaired->report.flippedFaces > 0);
    const auto normals = vertexNormals(repaired->mesh);
    for (Eigen::Index v = 0; v < mesh.vertexCount(); ++v)
        REQUIRE(normals.row(v).dot(repaired->mesh.vertices.row(v)) > 0.99);
}

TEST_CASE("An inside-out box is turned, an open sheet keeps its side") {
    auto box = boxMesh({1, 1, 1}, {2, 2, 2});
    box.faces.col(0).swap(box.faces.col(1));
    CHECK(signedVolumeM3(repairMesh(box)->mesh) > 0.99);
    auto sheet = sheetMesh(1, 0.5, 100);
    sheet.faces.col(0).swap(sheet.faces.col(1));
    std::swap(sheet.faces(3, 0), sheet.faces(3, 1));
    const auto repaired = repairMesh(sheet);
    CHECK(repaired->report.flippedFaces == 1);
    CHECK(vertexNormals(repaired->mesh).col(2).maxCoeff() < -0.99);
}

TEST_CASE("Components are counted, and the largest can be kept alone") {
    auto small = icosphereMesh(0.1, 1);
    small.vertices.col(0).array() += 3;
    const auto both = joined(small, icosphereMesh(1, 2));
    const auto all = repairMesh(both);
    CHECK(all->report.components == 2);
    CHECK_THAT(all->report.text(), ContainsSubstring("2 components"));
    const auto largest = repairMesh(both, {.largestComponentOnly = true});
    CHECK(largest->report.components == 1);
    CHECK(largest->report.droppedComponents == 1);
    CHECK(largest->mesh.vertexCount() == 162);
}

TEST_CASE("Open and non-manifold meshes work and are reported") {
    Mesh fan{Eigen::MatrixXd(5, 3), Eigen::MatrixXi(3, 3)}; // three faces on one edge
    fan.vertices << 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, -1, 0, 0;
    fan.faces << 0, 1, 2, 0, 1, 3, 0, 1, 4;
    const auto repaired = repairMesh(fan);
    REQUIRE(repaired);
    CHECK(repaired->report.nonManifoldEdges == 1);
    CHECK(repaired->report.boundaryEdges == 6);
}

TEST_CASE("Meshes that cannot be repaired are refused with a sentence") {
    auto mesh = icosphereMesh(1, 0);
    const auto errorOf = [](const Mesh& m) { return repairMesh(m).error().message; };
    CHECK_THAT(errorOf({mesh.vertices, Eigen::MatrixXi(0, 3)}), ContainsSubstring("no faces"));
    auto broken = mesh;
    broken.faces(2, 1) = 12;
    CHECK_THAT(errorOf(broken), ContainsSubstring("does not exist"));
    broken = mesh;
    broken.vertices(0, 0) = std::numeric_limits<double>::quiet_NaN();
    CHECK_THAT(errorOf(broken), ContainsSubstring("not a finite number"));
    broken = mesh;
    broken.vertices.setConstant(1);
    CHECK_THAT(errorOf(broken), ContainsSubstring("one point"));
    broken = mesh;
    broken.vertices.rightCols(2).setZero();
    CHECK_THAT(errorOf(broken), ContainsSubstring("no face with an area"));
}

TEST_CASE("A soup of a million separate triangles is repaired in less than quadratic time") {
    Mesh soup{Eigen::MatrixXd(3000000, 3), Eigen::MatrixXi(1000000, 3)};
    std::mt19937 random(5);
    for (double& coordinate : soup.vertices.reshaped())
        coordinate = static_cast<double>(random()) / 4294967296.0;
    for (int i = 0; i < 3000000; ++i)
        soup.faces(i / 3, i % 3) = i;
    const auto repaired = repairMesh(soup);
    REQUIRE(repaired);
    CHECK(repaired->report.components > 900000);
}
