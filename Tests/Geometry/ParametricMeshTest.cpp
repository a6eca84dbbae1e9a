#include "Geometry/ParametricMesh.h"
#include "Support/GeneratedMeshes.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;

namespace {

bool hasVertexAt(const Mesh& mesh, const Eigen::RowVector3d& point) {
    return (mesh.vertices.rowwise() - point).rowwise().norm().minCoeff() < 1e-9;
}

} // namespace

TEST_CASE(
    "A sheet has about the requested vertex count, a middle, corners and two mirror symmetries") {
    const int target = GENERATE(150, 600, 1000, 3000);
    const double length = GENERATE(0.39, 0.14), width = 0.04;
    const auto sheet = sheetMesh(length, width, target);
    CHECK(std::abs(static_cast<double>(sheet.vertexCount()) / target - 1) < 0.3);
    CHECK(hasVertexAt(sheet, {0, 0, 0}));
    CHECK(hasVertexAt(sheet, {-length / 2, -width / 2, 0}));
    CHECK(hasVertexAt(sheet, {length / 2, width / 2, 0}));
    CHECK_THAT(faceAreas(sheet).sum(), WithinRel(length * width, 1e-12));
    const auto edges = uniqueEdges(sheet);
    const auto middle = [&](const MeshEdge& edge) {
        return Eigen::RowVector3d((sheet.vertices.row(edge.a) + sheet.vertices.row(edge.b)) / 2);
    };
    for (const int axis : {0, 1})
        for (std::size_t i = 0; i < edges.size(); i += 7) {
            Eigen::RowVector3d image = middle(edges[i]);
            image(axis) = -image(axis);
            REQUIRE(std::ranges::any_of(
                edges, [&](const MeshEdge& edge) { return (middle(edge) - image).norm() < 1e-9; }));
        }
}

TEST_CASE("The triangles of a sheet are near-equilateral away from its ends") {
    const double length = 0.39, width = 0.04;
    const auto sheet = sheetMesh(length, width, 1000);
    const double mean = meanEdgeLengthMetres(sheet);
    for (const auto& edge : uniqueEdges(sheet)) {
        const Eigen::RowVector3d a = sheet.vertices.row(edge.a), b = sheet.vertices.row(edge.b);
        if (std::max(std::abs(a.x()), std::abs(b.x())) < length / 2 - 2 * mean)
            REQUIRE(std::abs((a - b).norm() / mean - 1) < 0.12);
    }
}

TEST_CASE("Sheets and discs look along +z") {
    for (const auto& mesh :
         {sheetMesh(0.3, 0.03, 300), discMesh(0.1, 6), gridPlateMesh(1, 1, 4, 3)})
        CHECK(vertexNormals(mesh).col(2).minCoeff() > 0.999);
}

TEST_CASE("Boxes and plates have the vertex counts of the zero-mode table") {
    CHECK(boxMesh({0.4, 0.05, 0.02}, {20, 4, 2}).vertexCount() == 258);
    CHECK(boxMesh({0.4, 0.05, 0.02}, {40, 6, 3}).vertexCount() == 758);
    CHECK(gridPlateMesh(0.4, 0.05, 20, 4).vertexCount() == 105);
    CHECK(gridPlateMesh(0.4, 0.05, 40, 8).vertexCount() == 369);
    CHECK(icosphereMesh(1, 4).vertexCount() == 2562);
}

TEST_CASE("Generated closed meshes have no boundary, look outward and have the right volume") {
    const double pi = std::numbers::pi;
    const auto sphere = icosphereMesh(0.5, 4);
    CHECK(isClosed(uniqueEdges(sphere)));
    CHECK_THAT(signedVolumeM3(sphere), WithinRel(4.0 / 3 * pi * 0.125, 0.01));
    const auto torus = torusMesh(0.1, 0.01, 80, 12);
    CHECK(isClosed(uniqueEdges(torus)));
    CHECK_THAT(signedVolumeM3(torus), WithinRel(2 * pi * pi * 0.1 * 1e-4, 0.06));
    CHECK(signedVolumeM3(boxMesh({1, 2, 3}, {2, 3, 4})) > 0);
}

TEST_CASE("A hoop is open only at its rims and looks outward") {
    const auto hoop = hoopMesh(0.1, 0.02, 60, 3);
    int boundary = 0;
    for (const auto& edge : uniqueEdges(hoop))
        boundary += edge.faceCount == 1;
    CHECK(boundary == 120);
    const auto normals = vertexNormals(hoop);
    for (Eigen::Index v = 0; v < hoop.vertexCount(); ++v)
        REQUIRE(normals.row(v).dot(hoop.vertices.row(v)) > 0);
}

TEST_CASE("Extruded sheets, discs and rings are closed, look outward and have the right volume") {
    const double pi = std::numbers::pi;
    const int layers = GENERATE(1, 2, 5);
    const auto plate = extrudedMesh(sheetMesh(0.4, 0.05, SheetGrid{20, 4}), 0.02, layers);
    CHECK(isClosed(uniqueEdges(plate)));
    CHECK_THAT(signedVolumeM3(plate), WithinRel(0.4 * 0.05 * 0.02, 1e-12));
    const auto disc = extrudedMesh(discMesh(0.1, 8), 0.01, layers);
    CHECK(isClosed(uniqueEdges(disc)));
    CHECK_THAT(signedVolumeM3(disc), WithinRel(pi * 1e-4, 0.004));
    const auto ring = extrudedMesh(annulusMesh(0.09, 0.11, 60, 2), 0.02, layers);
    CHECK(isClosed(uniqueEdges(ring)));
    CHECK(connectedComponents(ring).count == 1);
    CHECK_THAT(signedVolumeM3(ring), WithinRel(pi * (0.0121 - 0.0081) * 0.02, 0.005));
}

TEST_CASE("A hollow sphere has two closed surfaces and the volume of its wall") {
    const auto sphere = hollowSphereMesh(0.1, 0.004, 4);
    CHECK(isClosed(uniqueEdges(sphere)));
    CHECK(connectedComponents(sphere).count == 2);
    CHECK_THAT(signedVolumeM3(sphere), WithinRel(4 * std::numbers::pi * 0.01 * 0.004, 0.01));
}
