// Tests faces and vertices of a mesh that are held, through repair, remeshing and decimation.
#include "Analysis/HeldSurface.h"

#include "Analysis/ModalAnalysis.h"
#include "Geometry/ParametricMesh.h"
#include "Mesh/ObjectMesh.h"
#include "TestMaterials.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;

namespace {

constexpr double endMetres = -0.03;

AnalysisSettings settingsWith(Support support) {
    AnalysisSettings settings{.name = "held", .source = "a test", .material = referenceWood(0.3)};
    settings.maxFrequencyHz = 6000;
    settings.elementBudget = 600;
    settings.listeningDirections.clear();
    settings.support = std::move(support);
    return settings;
}

AnalysisSettings heldByBox() {
    return settingsWith({.clamps = {parseClamp("x<-0.02999").value()}});
}

Mesh bar(const Eigen::Vector3i& cells = {20, 2, 2}) {
    return boxMesh({0.06, 0.008, 0.004}, cells);
}

/// The faces whose corners all lie at the end of the bar.
std::vector<int> endFaces(const Mesh& mesh) {
    std::vector<int> faces;
    for (int face = 0; face < mesh.faceCount(); ++face)
        if ((mesh.vertices(mesh.faces.row(face), 0).array() < endMetres + 1e-6).all())
            faces.push_back(face);
    return faces;
}

void checkSame(const Result<ModalObject>& one, const Result<ModalObject>& other) {
    REQUIRE(one);
    REQUIRE(other);
    CHECK(one->eigenvalues == other->eigenvalues);
    CHECK(one->shapes == other->shapes);
    CHECK(one->clampedVertices == other->clampedVertices);
    CHECK(one->provenance.zeroModes == 0);
}

/// Each face has corners of its own, as in an STL, and stray vertices come first.
Mesh soupOf(const Mesh& mesh) {
    constexpr Eigen::Index strays = 5;
    Mesh soup{Eigen::MatrixXd::Constant(strays + 3 * mesh.faceCount(), 3, 0.5),
              Eigen::MatrixXi(mesh.faceCount(), 3)};
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 0; corner < 3; ++corner) {
            const auto row = strays + 3 * face + corner;
            soup.faces(face, corner) = static_cast<int>(row);
            soup.vertices.row(row) = mesh.vertices.row(mesh.faces(face, corner));
        }
    return soup;
}

} // namespace

TEST_CASE("Held faces equal a box around them bit for bit, with and without remeshing") {
    for (const auto& mesh : {bar(), bar({1, 1, 1}), bar({60, 8, 4})})
        checkSame(analyse(mesh, settingsWith({.faces = endFaces(mesh)})),
                  analyse(mesh, heldByBox()));
}

TEST_CASE("Held faces survive welding, and faces that repair drops or turns over") {
    auto mesh = soupOf(bar());
    mesh.faces.conservativeResize(mesh.faceCount() + 2, Eigen::NoChange);
    mesh.faces.bottomRows(2) << 0, 0, 1, 5, 6, 7; // without an area, and twice the same
    mesh.faces.row(3).reverseInPlace();
    checkSame(analyse(mesh, settingsWith({.faces = endFaces(mesh)})), analyse(mesh, heldByBox()));
}

TEST_CASE("A preview of a decimated mesh holds the same part") {
    const auto mesh = bar({60, 8, 4});
    REQUIRE(mesh.vertexCount() > previewVertices);
    const auto settings = settingsWith({.faces = endFaces(mesh)});
    const auto preview = analysePreview(mesh, settings), whole = analyse(mesh, settings);
    REQUIRE(preview);
    REQUIRE(whole);
    REQUIRE_FALSE(preview->clampedVertices.empty());
    for (const auto vertex : preview->clampedVertices)
        CHECK(std::abs(preview->vertices[3 * static_cast<std::size_t>(vertex)] - float(endMetres)) <
              1e-4f);
    CHECK_THAT(std::sqrt(preview->eigenvalues[0] / whole->eigenvalues[0]), WithinRel(1.0, 0.03));
}

TEST_CASE("A part of a round surface stays held where it is remeshed") {
    const auto mesh = icosphereMesh(0.02, 4);
    std::vector<int> cap;
    for (int face = 0; face < mesh.faceCount(); ++face)
        if ((mesh.vertices(mesh.faces.row(face), 2).array() > 0.01).all())
            cap.push_back(face);
    auto settings = settingsWith({.faces = cap});
    settings.maxFrequencyHz = 60000;
    settings.elementBudget = 1000;
    const auto held = analyse(mesh, settings);
    REQUIRE(held);
    CHECK(held->provenance.zeroModes == 0);
    REQUIRE(held->vertexCount() != static_cast<std::size_t>(mesh.vertexCount()));
    std::size_t above = 0;
    for (std::size_t vertex = 0; vertex < held->vertexCount(); ++vertex)
        above += held->vertices[3 * vertex + 2] > 0.0115f;
    for (const auto vertex : held->clampedVertices)
        CHECK(held->vertices[3 * static_cast<std::size_t>(vertex) + 2] > 0.0095f);
    CHECK(held->clampedVertices.size() >= above);
}

TEST_CASE("Held vertices hold the edge between them: an object is analysed again as it was held") {
    auto settings = heldByBox();
    settings.method = AnalysisMethod::twoLayer;
    settings.thicknessMetres = 0.001;
    const auto first = analyse(sheetMesh(0.06, 0.02, 70), settings);
    REQUIRE(first);
    REQUIRE(first->clampedVertices.size() > 2);
    settings.support = {.vertices = first->clampedVertices};
    const auto again = analyse(objectMesh(*first), settings);
    REQUIRE(again);
    CHECK(again->clampedVertices == first->clampedVertices);
    CHECK_THAT(again->eigenvalues[0], WithinRel(first->eigenvalues[0], 1e-4));
    settings.method.reset(); // a mesh as coarse as this is remeshed
    settings.maxFrequencyHz = 40000;
    const auto finer = analyse(objectMesh(*first), settings);
    REQUIRE(finer);
    REQUIRE(finer->vertexCount() > first->vertexCount());
    CHECK(finer->clampedVertices.size() > first->clampedVertices.size());
    CHECK_THAT(finer->eigenvalues[0], WithinRel(first->eigenvalues[0], 0.1));
}

TEST_CASE("A ball holds what lies in it, at least the vertex nearest to its centre") {
    const auto wide = analyse(bar(), settingsWith({.balls = {{{endMetres, 0, 0}, 0.0045}}}));
    const auto held = analyse(bar(), heldByBox());
    REQUIRE(wide);
    REQUIRE(held);
    CHECK(wide->clampedVertices.size() > held->clampedVertices.size());
    CHECK(wide->eigenvalues[0] > held->eigenvalues[0]);
    const auto narrow =
        analyse(bar(), settingsWith({.balls = {{{0, 0, 0.0021}, 0}, {{0.03, 0, 0.002}, 0}}}));
    REQUIRE(narrow);
    CHECK(narrow->clampedVertices.size() == 2);
}

TEST_CASE("Held faces and vertices that do not exist are refused in a sentence") {
    for (const auto& support :
         {Support{.faces = {1'000'000}}, Support{.faces = {-1}}, Support{.vertices = {1'000'000}}})
        CHECK(analyse(bar(), settingsWith(support)).error().message ==
              "A clamped part of the mesh does not exist.");
}
