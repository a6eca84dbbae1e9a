#include "Geometry/MeshRepair.h"

#include "Geometry/ParametricMesh.h"
#include "Geometry/TestMeshes.h"
#include "Object/WorkControl.h"
#include "Support/GeneratedMeshes.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <limits>
#include <random>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;

namespace {

bool changedAnything(const RepairReport& report) {
    return report.weldedVertices + report.degenerateFaces + report.duplicateFaces +
               report.joinedVertices + report.unreferencedVertices + report.flippedFaces +
               report.cutVertices + report.droppedComponents >
           0;
}

} // namespace

TEST_CASE("Repair leaves a good mesh unchanged") {
    for (const auto& mesh : {icosphereMesh(0.1, 3), sheetMesh(0.4, 0.05, 500)}) {
        const auto repaired = repairMesh(mesh);
        REQUIRE(repaired);
        CHECK(repaired->mesh.vertices == mesh.vertices);
        CHECK(repaired->mesh.faces == mesh.faces);
        CHECK_FALSE(changedAnything(repaired->report));
    }
}

TEST_CASE("A soup of triangles is welded into the closed surface that it forms") {
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
    CHECK_THAT(repaired->report.text(), ContainsSubstring("points that lay on others"));
    for (const int vertex : repaired->vertexOfInput)
        REQUIRE((vertex >= 0 && vertex < sphere.vertexCount()));
}

TEST_CASE("Vertices within the weld tolerance become one at any position") {
    const auto sphere = icosphereMesh(0.1, 3);
    auto soup = soupOf(sphere);
    const double toleranceMetres = 1e-7 * boundingDiagonalMetres(sphere);
    std::mt19937 random(6);
    for (double& coordinate : soup.vertices.reshaped()) // at most 0.87 of the tolerance apart
        coordinate += 0.25 * toleranceMetres * (static_cast<double>(random() % 2001) / 1000 - 1);
    const auto repaired = repairMesh(soup);
    REQUIRE(repaired);
    CHECK(repaired->mesh.vertexCount() == sphere.vertexCount());
    CHECK(isClosed(uniqueEdges(repaired->mesh)));
}

TEST_CASE("A fan of half a million separate triangles is welded at its hub") {
    constexpr int triangles = 500000;
    Mesh fan{Eigen::MatrixXd::Zero(3 * triangles, 3), Eigen::MatrixXi(triangles, 3)};
    const auto rim = [](int i) {
        const double angle = 3.0 * i / triangles; // an open fan
        return Eigen::RowVector3d(std::cos(angle), std::sin(angle), 0);
    };
    for (int i = 0; i < triangles; ++i) {
        fan.vertices.row(3 * i + 1) = rim(i);
        fan.vertices.row(3 * i + 2) = rim(i + 1);
        fan.faces.row(i) << 3 * i, 3 * i + 1, 3 * i + 2;
    }
    const auto repaired = repairMesh(fan);
    REQUIRE(repaired);
    CHECK(repaired->mesh.vertexCount() == triangles + 2);
    CHECK(repaired->report.boundaryEdges == triangles + 2);
}

TEST_CASE("Vertices farther apart than the weld tolerance stay separate") {
    Mesh mesh{Eigen::MatrixXd(4, 3), Eigen::MatrixXi(2, 3)};
    mesh.vertices << 0, 0, 0, 3, 4, 0, 3, 0, 0, 3, 0, 5.1e-7;
    mesh.faces << 0, 1, 2, 1, 0, 3;
    CHECK(repairMesh(mesh)->report.weldedVertices == 0);
    mesh.vertices(3, 2) = 4.9e-7;
    CHECK(repairMesh(mesh)->report.weldedVertices == 1);
}

TEST_CASE("A second repair changes nothing, even if the first dropped the farthest vertices") {
    Mesh mesh;
    SECTION("two corners of a face nearly coincide") {
        mesh.vertices.resize(6, 3);
        mesh.vertices.row(0) << 1, 1.0000002, 1;
        mesh.vertices.row(1) << 4, 1.0000001, 1.0000001;
        mesh.vertices.row(2) << 1.0000001, 1.0000001, 1.0000001;
        mesh.vertices.row(3) << 1.0000001, 3, 1.0000001;
        mesh.vertices.row(4) << 1, 1, 1.0000001;
        mesh.vertices.row(5) << 4, 1.5, 1;
        mesh.faces.resize(3, 3);
        mesh.faces << 2, 1, 0, 4, 2, 3, 1, 5, 2;
    }
    SECTION("a vertex lies on an edge near its end, and another has no face") {
        mesh.vertices.resize(5, 3);
        mesh.vertices << 0, 0, 0, 0.25, 0, 0, 0, 0.25, 0, 6e-7, 0, 0, 0, 0, 1;
        mesh.faces.resize(2, 3);
        mesh.faces << 0, 1, 2, 0, 3, 2;
    }
    const auto repaired = repairMesh(mesh);
    REQUIRE(repaired);
    CHECK(boundingDiagonalMetres(repaired->mesh) < 0.9 * boundingDiagonalMetres(mesh));
    const auto again = repairMesh(repaired->mesh);
    REQUIRE(again);
    INFO(again->report.text());
    CHECK_FALSE(changedAnything(again->report));
}

TEST_CASE("An open mesh with many faceless vertices is reported as possibly cut off") {
    const auto whole = icosphereMesh(1, 2);
    const auto textOf = [](const Mesh& mesh) { return repairMesh(mesh)->report.text(); };
    const std::string said = "the end of the mesh may be missing";
    CHECK_THAT(textOf({whole.vertices, whole.faces.topRows(whole.faceCount() * 3 / 4)}),
               ContainsSubstring(said));
    CHECK_THAT(textOf(whole), !ContainsSubstring(said));
    // Holes without loose vertices, stray vertices beside a sheet and extra vertices in the list of
    // a closed mesh are not reported.
    CHECK_THAT(textOf({whole.vertices, whole.faces.topRows(whole.faceCount() - 2)}),
               !ContainsSubstring(said));
    const auto sheet = sheetMesh(1, 1, 40);
    Mesh strays{Eigen::MatrixXd(sheet.vertexCount() + 8, 3), sheet.faces};
    strays.vertices << sheet.vertices, Eigen::MatrixXd::Random(8, 3);
    CHECK_THAT(textOf(strays), !ContainsSubstring(said));
    Mesh listed{Eigen::MatrixXd(whole.vertexCount() + 50, 3), whole.faces};
    listed.vertices << whole.vertices, Eigen::MatrixXd::Random(50, 3);
    CHECK_THAT(textOf(listed), !ContainsSubstring(said));
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

TEST_CASE("Randomly turned faces are oriented outward again") {
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

TEST_CASE("An inside-out box is turned over, and an open sheet keeps its side") {
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

TEST_CASE("Components are counted, and optionally only the largest is kept") {
    auto small = icosphereMesh(0.1, 1);
    small.vertices.col(0).array() += 3;
    const auto both = joined(small, icosphereMesh(1, 2));
    const auto all = repairMesh(both);
    CHECK(all->report.components == 2);
    CHECK_THAT(all->report.text(), ContainsSubstring("It has 2 parts that do not touch"));
    const auto largest = repairMesh(both, {.largestComponentOnly = true});
    CHECK(largest->report.components == 1);
    CHECK(largest->report.droppedComponents == 1);
    CHECK(largest->mesh.vertexCount() == 162);
}

TEST_CASE("Open and non-manifold meshes are repaired and reported") {
    Mesh fan{Eigen::MatrixXd(5, 3), Eigen::MatrixXi(3, 3)}; // three faces on one edge
    fan.vertices << 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, -1, 0, 0;
    fan.faces << 0, 1, 2, 0, 1, 3, 0, 1, 4;
    const auto repaired = repairMesh(fan);
    REQUIRE(repaired);
    CHECK(repaired->report.nonManifoldEdges == 1);
    CHECK(repaired->report.boundaryEdges == 6);
}

TEST_CASE("A cube with one finer side is closed at its T-junctions") {
    const int segments = GENERATE(1, 3);
    const auto cube = tJunctionCube(segments);
    const auto repaired = repairMesh(cube);
    REQUIRE(repaired);
    CHECK(repaired->report.joinedVertices == 4 * segments);
    CHECK(isClosed(uniqueEdges(repaired->mesh)));
    CHECK(isOrientedManifold(repaired->mesh));
    CHECK(std::abs(signedVolumeM3(repaired->mesh) - 1) < 1e-12);
    CHECK_THAT(repaired->report.text(), ContainsSubstring("Closed the gap at"));
}

TEST_CASE("A vertex is joined to an edge within ten weld tolerances, and not beyond") {
    Mesh mesh{Eigen::MatrixXd(6, 3), Eigen::MatrixXi(3, 3)};
    mesh.vertices << 0, 0, 0, 1, 0, 0, 0.5, 1, 0, 0.4, 0, 0, 0.2, -1, 0, 0.8, -1, 0;
    mesh.faces << 0, 1, 2, 0, 4, 3, 1, 3, 5;
    mesh.vertices(3, 1) = -5e-7;
    CHECK(repairMesh(mesh)->report.joinedVertices == 1);
    CHECK(repairMesh(mesh)->mesh.faceCount() == 4);
    CHECK(repairMesh(mesh)->report.boundaryEdges == 6);
    mesh.vertices(3, 1) = -5e-6;
    CHECK(repairMesh(mesh)->report.joinedVertices == 0);
}

TEST_CASE("T-junctions are joined until none is left, even over many rounds") {
    Mesh mesh{Eigen::MatrixXd(16, 3), Eigen::MatrixXi(23, 3)};
    mesh.vertices << 13, 15, 3, 13, 8, 6, 5, 0, 0, 0, 8, 14.25, 0, 0, 8, 0, 0, 4, 1e-7, 0, 1e-7, 0,
        0, 8, 0, 8, 0, 0, 0, 9, 0, 0, 0, 13, 0, 0, 0, 0, 0, 0, 0, 6, 0, 0, 11.5, 11, 0, 0;
    mesh.faces << 0, 1, 2, 3, 2, 3, 3, 3, 4, 5, 4, 6, 5, 5, 6, 0, 1, 4, 4, 0, 0, 0, 1, 1, 4, 9, 3,
        3, 3, 4, 5, 4, 6, 14, 5, 6, 0, 1, 4, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 10, 11, 10, 12, 11, 11,
        12, 13, 13, 12, 14, 13, 13, 14, 15, 14, 1, 15, 15, 1;
    const auto repaired = repairMesh(mesh);
    REQUIRE(repaired);
    const auto again = repairMesh(repaired->mesh);
    REQUIRE(again);
    INFO(again->report.text());
    CHECK_FALSE(changedAnything(again->report));
}

TEST_CASE("A cap, a face with its apex on its longest side, is replaced without a gap") {
    Mesh mesh{Eigen::MatrixXd(5, 3), Eigen::MatrixXi(4, 3)};
    mesh.vertices << 0, 0, 0, 1, 0, 0, 0.5, 0, 0, 0.5, -1, 0, 0.5, 1, 0;
    mesh.faces << 0, 2, 1, 0, 3, 1, 0, 2, 4, 2, 1, 4;
    const auto repaired = repairMesh(mesh);
    REQUIRE(repaired);
    CHECK(repaired->report.degenerateFaces == 1);
    CHECK(repaired->mesh.faceCount() == 4);
    CHECK(repaired->report.boundaryEdges == 4);
}

TEST_CASE("Two cubes that share an edge look outward and are cut into closed cubes") {
    const auto cube = boxMesh({1, 1, 1}, {2, 2, 2});
    for (const auto& both : {joined(cube, moved(cube, {1, 1, 0})),
                             joined(insideOut(cube), moved(insideOut(cube), {1, 1, 0})),
                             joined(cube, moved(insideOut(cube), {1, 1, 0}))}) {
        const auto kept = repairMesh(both);
        REQUIRE(kept);
        CHECK(kept->report.nonManifoldEdges == 2);
        CHECK(kept->report.components == 1);
        CHECK(std::abs(signedVolumeM3(kept->mesh) - 2) < 1e-12);
        const auto cut = repairMesh(both, {.cutIntoManifold = true});
        REQUIRE(cut);
        CHECK(isOrientedManifold(cut->mesh));
        CHECK(cut->report.nonManifoldEdges == 0);
        CHECK(cut->report.boundaryEdges == 0);
        CHECK(std::abs(signedVolumeM3(cut->mesh) - 2) < 1e-12);
    }
    const auto apart = repairMesh(joined(cube, moved(cube, {1, 1, 0})), {.cutIntoManifold = true});
    CHECK(apart->report.components == 2);
    CHECK(apart->report.cutVertices == 3);
}

TEST_CASE("Two cubes that share a vertex are cut apart") {
    const auto cube = boxMesh({1, 1, 1}, {1, 1, 1});
    const auto both = joined(cube, moved(cube, {1, 1, 1}));
    CHECK(repairMesh(both)->report.components == 1);
    const auto cut = repairMesh(both, {.cutIntoManifold = true});
    CHECK(cut->report.components == 2);
    CHECK(cut->report.cutVertices == 1);
    CHECK(isOrientedManifold(cut->mesh));
}

TEST_CASE("A sphere inside a sphere bounds a hollow, and a third sphere inside the hollow is solid "
          "again") {
    const auto outer = icosphereMesh(1, 3), middle = icosphereMesh(0.5, 2),
               inner = icosphereMesh(0.25, 2);
    const auto hollow = repairMesh(joined(middle, outer));
    REQUIRE(hollow);
    CHECK(hollow->report.hollows == 1);
    CHECK(std::abs(signedVolumeM3(hollow->mesh) -
                   (signedVolumeM3(outer) - signedVolumeM3(middle))) < 1e-12);
    const auto three = repairMesh(joined(joined(middle, insideOut(outer)), inner));
    CHECK(three->report.hollows == 1);
    CHECK(std::abs(signedVolumeM3(three->mesh) - (signedVolumeM3(outer) - signedVolumeM3(middle) +
                                                  signedVolumeM3(inner))) < 1e-12);
    CHECK(repairMesh(joined(outer, moved(outer, {3, 0, 0})))->report.hollows == 0);
}

TEST_CASE("Closed surfaces all look outward if a search for hollows would take too long") {
    // Folded plates, each of which encloses the centres of all narrower ones.
    constexpr int pleats = 100, blankets = 300;
    const auto blanket = [&](int number) {
        Mesh mesh = boxMesh({1, 1 - 1e-4 * number, 0.02}, {pleats, 1, 1});
        for (Eigen::Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
            mesh.vertices(vertex, 2) +=
                std::lround((mesh.vertices(vertex, 0) + 0.5) * pleats) % 2 == 0 ? 0 : 1;
        return mesh;
    };
    const Mesh one = blanket(0);
    const auto vertices = one.vertexCount(), faces = one.faceCount();
    Mesh all{Eigen::MatrixXd(blankets * vertices, 3), Eigen::MatrixXi(blankets * faces, 3)};
    for (int number = 0; number < blankets; ++number) {
        all.vertices.middleRows(number * vertices, vertices) = blanket(number).vertices;
        all.faces.middleRows(number * faces, faces) =
            one.faces.array() + static_cast<int>(number * vertices);
    }
    const auto repaired = repairMesh(insideOut(all));
    REQUIRE(repaired);
    CHECK(repaired->report.isTangled);
    CHECK(repaired->report.hollows == 0);
    CHECK(repaired->report.flippedFaces == repaired->mesh.faceCount());
    CHECK_THAT(repaired->report.text(), ContainsSubstring("too tangled to tell which"));
}

TEST_CASE("A cancelled repair reports the cancellation") {
    const std::atomic<bool> cancelled = true;
    const auto repaired = repairMesh(icosphereMesh(1, 2), {.cancelled = &cancelled});
    REQUIRE_FALSE(repaired);
    CHECK(isCancellation(repaired.error()));
}

TEST_CASE("One-sided surfaces are reported, and are cut along a seam") {
    const auto strip = repairMesh(moebiusStrip(40, 4));
    REQUIRE(strip);
    CHECK(strip->report.oneSidedEdges > 0);
    CHECK_THAT(strip->report.text(), ContainsSubstring("has one side only"));
    for (const auto& mesh : {moebiusStrip(40, 4), kleinBottle(30, 20)}) {
        const auto cut = repairMesh(mesh, {.cutIntoManifold = true});
        REQUIRE(cut);
        CHECK(isOrientedManifold(cut->mesh));
        CHECK(cut->report.cutVertices > 0);
        CHECK(cut->report.components == 1);
        CHECK(std::abs(faceAreas(cut->mesh).sum() - faceAreas(mesh).sum()) < 1e-9);
    }
}

TEST_CASE("Many faces at one edge are cut into sheets of two faces, and an odd face stays alone") {
    const int pages = GENERATE(3, 5, 6, 101);
    const auto cut = repairMesh(book(pages), {.cutIntoManifold = true});
    REQUIRE(cut);
    CHECK(isOrientedManifold(cut->mesh));
    CHECK(cut->mesh.faceCount() == pages);
    CHECK(cut->report.components == (pages + 1) / 2);
}

TEST_CASE("Meshes that cannot be repaired give an error with the reason") {
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
    CHECK_THAT(errorOf({mesh.vertices * 1e10, mesh.faces}), ContainsSubstring("unit"));
    CHECK_THAT(errorOf({mesh.vertices * 1e-11, mesh.faces}), ContainsSubstring("unit"));
}

TEST_CASE("A soup of a million separate triangles is repaired and stays separate") {
    const auto repaired = repairMesh(triangleSoup());
    REQUIRE(repaired);
    CHECK(repaired->report.components > 900000);
}
