#include "Analysis/TetMesh.h"

#include "Analysis/TetGenMesher.h"
#include "Geometry/ParametricMesh.h"
#include "Geometry/TestMeshes.h"
#include "Object/WorkControl.h"
#include "Support/GeneratedMeshes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <chrono>
#include <cmath>
#include <future>
#include <limits>
#include <map>
#include <mutex>
#include <numbers>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;

namespace {

/// Counts element faces (three corners) that belong to one element only.
int outerFaces(const TetMesh& mesh) {
    std::map<std::array<int, 3>, int> uses;
    for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t)
        for (int left = 0; left < 4; ++left) {
            std::array<int, 3> face{};
            for (int k = 0, i = 0; k < 4; ++k)
                if (k != left)
                    face[i++] = mesh.tetrahedra(t, k);
            std::ranges::sort(face);
            ++uses[face];
        }
    return static_cast<int>(
        std::ranges::count_if(uses, [](const auto& use) { return use.second == 1; }));
}

} // namespace

TEST_CASE("Surface vertices keep their indices and positions, whether or not the surface may be "
          "divided") {
    const bool keep = GENERATE(true, false);
    const auto surface = icosphereMesh(0.1, 2);
    const auto mesh = tetrahedralise(surface, {.targetEdgeMetres = 0.03, .keepSurface = keep});
    REQUIRE(mesh);
    CHECK(mesh->surfaceVertexCount == surface.vertexCount());
    CHECK(mesh->nodes.topRows(surface.vertexCount()) == surface.vertices);
}

TEST_CASE("Elements have the same orientation, fill the body, and have nodes at mid-edge") {
    const auto surface = extrudedMesh(sheetMesh(0.4, 0.05, SheetGrid{20, 2}), 0.02);
    const auto mesh = tetrahedralise(surface, {.targetEdgeMetres = 0.02});
    REQUIRE(mesh);
    CHECK_THAT(volumeM3(*mesh), WithinRel(signedVolumeM3(surface), 1e-12));
    std::vector<bool> used(static_cast<std::size_t>(mesh->nodes.rows()), false);
    for (const auto& element : mesh->tetrahedra.rowwise()) {
        const Eigen::Vector3d a = mesh->nodes.row(element(0)), b = mesh->nodes.row(element(1)),
                              c = mesh->nodes.row(element(2)), d = mesh->nodes.row(element(3));
        REQUIRE((b - a).cross(c - a).dot(d - a) > 0);
        for (int e = 0; e < 6; ++e) {
            const auto [p, q] = tetrahedronEdges[e];
            REQUIRE((mesh->nodes.row(element(4 + e)) -
                     (mesh->nodes.row(element(p)) + mesh->nodes.row(element(q))) / 2)
                        .norm() < 1e-15);
        }
        for (const int node : element)
            used[static_cast<std::size_t>(node)] = true;
    }
    CHECK(std::ranges::all_of(used, [](bool is) { return is; }));
    CHECK(outerFaces(*mesh) == surface.faceCount());
}

TEST_CASE("The mean edge of a thick body is within 20 % of the target") {
    const double edge = GENERATE(0.25, 0.125);
    const int segments = static_cast<int>(std::lround(1 / edge));
    const auto surface = boxMesh({1, 1, 1}, {segments, segments, segments});
    for (const bool keep : {true, false}) {
        const auto mesh = tetrahedralise(surface, {.targetEdgeMetres = edge, .keepSurface = keep});
        REQUIRE(mesh);
        CHECK_THAT(meanEdgeLengthMetres(*mesh), WithinRel(edge, 0.2));
    }
}

TEST_CASE("A box of twelve triangles is divided to the target if its surface may change") {
    const auto mesh = tetrahedralise(boxMesh({1, 1, 1}, {1, 1, 1}),
                                     {.targetEdgeMetres = 0.25, .keepSurface = false});
    REQUIRE(mesh);
    CHECK_THAT(meanEdgeLengthMetres(*mesh), WithinRel(0.25, 0.2));
}

TEST_CASE("A thin plate with a fixed surface gets one layer of flat elements") {
    const auto surface = extrudedMesh(sheetMesh(1, 1, 300), 0.01);
    const auto mesh = tetrahedralise(surface, {.targetEdgeMetres = 0.07});
    REQUIRE(mesh);
    // Three tetrahedra per prism and hardly any interior node.
    CHECK(mesh->tetrahedra.rows() < 3.3 * static_cast<double>(surface.faceCount()) / 2);
}

TEST_CASE("Cavities stay empty whichever way their faces are oriented") {
    auto surface = hollowSphereMesh(0.1, 0.02, 2);
    const double wall = signedVolumeM3(surface);
    const bool flipped = GENERATE(false, true);
    if (flipped) {
        const Eigen::Index half = surface.faceCount() / 2;
        surface.faces.bottomRows(half) = surface.faces.bottomRows(half).rowwise().reverse().eval();
    }
    const auto mesh = tetrahedralise(surface, {.targetEdgeMetres = 0.03});
    REQUIRE(mesh);
    CHECK_THAT(volumeM3(*mesh), WithinRel(wall, 1e-12));
}

TEST_CASE("Separate bodies are all filled") {
    const auto box = boxMesh({1, 1, 1}, {2, 2, 2});
    const auto mesh = tetrahedralise(joined(box, moved(box, {3, 0, 0})), {.targetEdgeMetres = 0.5});
    REQUIRE(mesh);
    CHECK_THAT(volumeM3(*mesh), WithinRel(2, 1e-12));
}

TEST_CASE("The same surface gives the same mesh, also on several threads at once") {
    const auto surface = icosphereMesh(0.1, 2);
    const TetMeshSettings settings{.targetEdgeMetres = 0.03};
    const auto first = tetrahedralise(surface, settings);
    REQUIRE(first);
    std::array<std::future<Result<TetMesh>>, 3> others;
    for (auto& other : others)
        other = std::async(std::launch::async, [&] { return tetrahedralise(surface, settings); });
    for (auto& future : others) {
        const auto other = future.get();
        REQUIRE(other);
        CHECK(other->nodes == first->nodes);
        CHECK(other->tetrahedra == first->tetrahedra);
    }
}

TEST_CASE("A cancelled call stops waiting for TetGen, and later calls succeed") {
    const auto surface = icosphereMesh(0.1, 1);
    std::atomic<bool> cancelled = false;
    std::unique_lock another(tetGenTurn());
    auto waiting = std::async(std::launch::async, [&] {
        return tetrahedralise(surface, {.targetEdgeMetres = 0.05, .cancelled = &cancelled});
    });
    cancelled = true;
    // The waiting call must end while the other thread still holds TetGen. The timeout only ends a
    // failing test.
    const bool ended = waiting.wait_for(std::chrono::seconds(60)) == std::future_status::ready;
    another.unlock();
    CHECK(ended);
    const auto stopped = waiting.get();
    REQUIRE_FALSE(stopped);
    CHECK(stopped.error().message == cancelledMessage);
    CHECK(tetrahedralise(surface, {.targetEdgeMetres = 0.05}));
}

TEST_CASE("Bodies that cannot be filled give a one-sentence error") {
    const auto box = boxMesh({1, 1, 1}, {2, 2, 2});
    const auto messageOf = [](const Mesh& surface, const TetMeshSettings& settings) {
        const auto mesh = tetrahedralise(surface, settings);
        REQUIRE_FALSE(mesh);
        CHECK(mesh.error().message.ends_with("."));
        return mesh.error().message;
    };
    CHECK(messageOf(sheetMesh(1, 1, 100), {.targetEdgeMetres = 0.1}).find("not closed") !=
          std::string::npos);
    CHECK(messageOf(box, {.targetEdgeMetres = 0}).find("edge length") != std::string::npos);
    CHECK(messageOf(box, {.targetEdgeMetres = std::numeric_limits<double>::quiet_NaN()})
              .find("edge length") != std::string::npos);
    CHECK(messageOf(box, {.targetEdgeMetres = 0.01, .keepSurface = false, .maximumNodes = 3000})
              .find("more than 3000 points") != std::string::npos);
}

TEST_CASE("Two crossing boxes give an error, not a crash") {
    const auto box = boxMesh({1, 1, 1}, {2, 2, 2});
    const auto crossing = joined(box, moved(box, {0.37, 0.21, 0.13}));
    for (const bool keep : {true, false}) {
        const auto mesh = tetrahedralise(crossing, {.targetEdgeMetres = 0.4, .keepSurface = keep});
        REQUIRE_FALSE(mesh);
    }
}
