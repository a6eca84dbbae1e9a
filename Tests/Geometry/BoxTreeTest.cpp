#include "Geometry/BoxTree.h"

#include "Geometry/ParametricMesh.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <vector>

using namespace idiophone;

namespace {

constexpr BoxSearch plenty{.pairs = 5'000'000, .boxes = 200'000'000};

Mesh shuffled(const Mesh& mesh) {
    std::vector<int> order(static_cast<std::size_t>(mesh.faceCount()));
    std::iota(order.begin(), order.end(), 0);
    std::ranges::shuffle(order, std::mt19937(1));
    return {mesh.vertices, mesh.faces(order, Eigen::all)};
}

/// A corrugated sheet. Each fold is as long as the sheet.
Mesh washboard(int strips, double pitchMetres) {
    Mesh mesh{Eigen::MatrixXd(2 * (strips + 1), 3), Eigen::MatrixXi(2 * strips, 3)};
    for (int fold = 0; fold <= strips; ++fold)
        for (int end = 0; end < 2; ++end)
            mesh.vertices.row(2 * fold + end) << end, fold * pitchMetres, fold % 2 * pitchMetres;
    for (int strip = 0; strip < strips; ++strip) {
        const int first = 2 * strip;
        mesh.faces.row(first) << first, first + 1, first + 2;
        mesh.faces.row(first + 1) << first + 1, first + 3, first + 2;
    }
    return mesh;
}

/// Thin triangles side by side, 2e-5 apart, each 1 wide and 1 high.
Mesh slivers(int count) {
    Mesh mesh{Eigen::MatrixXd(3 * count, 3), Eigen::MatrixXi(count, 3)};
    for (int sliver = 0; sliver < count; ++sliver) {
        const double y = 2e-5 * sliver;
        mesh.vertices.middleRows(3 * sliver, 3) << 0, y, 0, 1, y, 1, 1, y + 1e-5, 0;
        mesh.faces.row(sliver) << 3 * sliver, 3 * sliver + 1, 3 * sliver + 2;
    }
    return mesh;
}

/// Faces around the origin, with distances and sizes from 1e-12 to 1.
Mesh unevenFaces(int count) {
    Mesh mesh{Eigen::MatrixXd(3 * count, 3), Eigen::MatrixXi(count, 3)};
    std::mt19937 random(1);
    std::uniform_real_distribution<double> exponent(-12, 0), anywhere(-1, 1);
    for (int face = 0; face < count; ++face) {
        const double scale = std::pow(10, exponent(random));
        const Eigen::RowVector3d way(anywhere(random), anywhere(random), anywhere(random));
        auto corners = mesh.vertices.middleRows(3 * face, 3);
        corners = (scale * way).replicate(3, 1);
        corners.bottomRightCorner(2, 2).diagonal().array() += 1e-3 * scale;
        mesh.faces.row(face) << 3 * face, 3 * face + 1, 3 * face + 2;
    }
    return mesh;
}

} // namespace

TEST_CASE("Coincident faces all touch each other, and faces in a row touch their neighbours only") {
    Mesh same{Eigen::MatrixXd{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Eigen::MatrixXi(10, 3)};
    same.faces.rowwise() = Eigen::RowVector3i(0, 1, 2);
    const auto pairs = [](const Mesh& mesh, std::size_t most) {
        const auto touching = BoxTree(mesh).touchingFaces({.pairs = most, .boxes = plenty.boxes});
        return touching ? std::optional(touching->pairs) : std::nullopt;
    };
    CHECK(pairs(same, 45) == 45);
    CHECK_FALSE(pairs(same, 44));
    Mesh row{Eigen::MatrixXd(30, 3), Eigen::MatrixXi(10, 3)};
    for (int face = 0; face < 10; ++face)
        for (int corner = 0; corner < 3; ++corner) {
            row.vertices.row(3 * face + corner) << face + (corner == 1), corner == 2, 0;
            row.faces(face, corner) = 3 * face + corner;
        }
    CHECK(pairs(row, 1000) == 9);
    CHECK(pairs({row.vertices, Eigen::MatrixXi(0, 3)}, 0) == 0);
}

TEST_CASE(
    "A good mesh has some ten neighbours per face, and a search of coincident faces ends early") {
    const auto ball = icosphereMesh(1, 6); // of 81920 faces
    const auto faces = static_cast<std::size_t>(ball.faceCount());
    const auto touching = BoxTree(ball).touchingFaces(plenty);
    REQUIRE(touching);
    CHECK(touching->pairs > 6 * faces);
    CHECK(touching->pairs < 20 * faces);
    CHECK(touching->boxes < 100 * faces);
    Mesh heap{Eigen::MatrixXd{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Eigen::MatrixXi(1'000'000, 3)};
    heap.faces.rowwise() = Eigen::RowVector3i(0, 1, 2);
    CHECK_FALSE(BoxTree(heap).touchingFaces(plenty));
}

TEST_CASE("Long thin faces side by side need no more boxes than round ones") {
    constexpr int faces = 100'000;
    // At the smaller pitch each face is longer than the whole sheet is wide.
    for (const double pitchMetres : {1e-4, 1e-6})
        for (const auto& mesh :
             {washboard(faces / 2, pitchMetres), shuffled(washboard(faces / 2, pitchMetres))}) {
            const auto touching = BoxTree(mesh).touchingFaces(plenty);
            REQUIRE(touching);
            CHECK(touching->pairs == 249'996);
            CHECK(touching->boxes < 100 * faces);
        }
    for (const auto& mesh : {slivers(faces), shuffled(slivers(faces))}) {
        const auto touching = BoxTree(mesh).touchingFaces(plenty);
        REQUIRE(touching);
        CHECK(touching->pairs == 0);
        CHECK(touching->boxes < 100 * faces);
    }
}

TEST_CASE("Faces of very different sizes need no more boxes than equal faces") {
    constexpr int faces = 100'000;
    const auto touching = BoxTree(unevenFaces(faces)).touchingFaces(plenty);
    REQUIRE(touching);
    CHECK(touching->pairs < faces);
    CHECK(touching->boxes < 100 * faces);
}

TEST_CASE("A search that needs too many boxes fails, even without any pair") {
    const auto mesh = slivers(1000);
    const auto boxes = BoxTree(mesh).touchingFaces(plenty).value().boxes;
    CHECK(BoxTree(mesh).touchingFaces({.pairs = 0, .boxes = boxes}));
    CHECK_FALSE(BoxTree(mesh).touchingFaces({.pairs = 0, .boxes = boxes - 1}));
}
