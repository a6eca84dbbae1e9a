#include "Analysis/SolidBar.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <map>

using namespace idiophone;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr UndercutBar bar{.lengthMetres = 0.3,
                          .widthMetres = 0.04,
                          .heightMetres = 0.02,
                          .centreHeightMetres = 0.012,
                          .endHeightMetres = 0.018,
                          .archHalfLengthShare = 0.3,
                          .archExponent = 1};

double signedVolume(const Mesh& mesh) {
    double sum = 0;
    for (const auto& face : mesh.faces.rowwise()) {
        const auto corner = [&](int k) {
            return Eigen::Vector3d(mesh.vertices.row(face(k)).transpose());
        };
        sum += corner(0).dot(corner(1).cross(corner(2))) / 6;
    }
    return sum;
}

} // namespace

TEST_CASE("A solid bar's elements and its closed surface enclose the bar's volume") {
    // With straight flanks the grid is exact: mean height times base area.
    const double mean = 0.6 * (0.012 + 0.02) / 2 + 0.4 * (0.02 + 0.018) / 2;
    for (const BarGrid grid : {BarGrid{8, 2, 1}, BarGrid{20, 4, 3}}) {
        const SolidBar solid = solidBar(bar, grid);
        CHECK_THAT(volumeM3(solid.elements), WithinRel(0.3 * 0.04 * mean, 1e-12));
        CHECK_THAT(signedVolume(solid.surface), WithinRel(0.3 * 0.04 * mean, 1e-12));
        CHECK(solid.elements.surfaceVertexCount == solid.surface.vertexCount());
        std::map<std::pair<int, int>, int> edges;
        for (const auto& face : solid.surface.faces.rowwise())
            for (int k = 0; k < 3; ++k)
                ++edges[{face(k), face((k + 1) % 3)}];
        for (const auto& [edge, uses] : edges) {
            CHECK(uses == 1);
            CHECK(edges.contains({edge.second, edge.first}));
        }
    }
}

TEST_CASE("A solid bar is mirror-symmetric in x and y") {
    const SolidBar solid = solidBar(bar, {12, 4, 2});
    const auto& nodes = solid.elements.nodes;
    const auto key = [](const Eigen::Vector3d& at) {
        const Eigen::Vector3d grains = at * 1e9;
        return std::array{std::lround(grains.x()), std::lround(grains.y()),
                          std::lround(grains.z())};
    };
    std::map<std::array<long, 3>, int> numberAt;
    for (Eigen::Index n = 0; n < nodes.rows(); ++n)
        numberAt[key(nodes.row(n).transpose())] = static_cast<int>(n);
    for (const Eigen::Vector3d& mirror : {Eigen::Vector3d(-1, 1, 1), Eigen::Vector3d(1, -1, 1)}) {
        const auto imageOf = [&](int node) {
            return numberAt.at(key(nodes.row(node).transpose().cwiseProduct(mirror)));
        };
        std::map<std::array<int, 4>, int> elements;
        for (const auto& element : solid.elements.tetrahedra.rowwise()) {
            std::array<int, 4> corners{element(0), element(1), element(2), element(3)};
            std::ranges::sort(corners);
            ++elements[corners];
        }
        for (const auto& [corners, count] : elements) {
            auto image = corners;
            for (int& corner : image)
                corner = imageOf(corner);
            std::ranges::sort(image);
            CHECK(elements.contains(image));
        }
    }
}

TEST_CASE("The edges of the arch lie on grid lines, and mid-edge nodes lie in the middle") {
    const SolidBar solid = solidBar(bar, {16, 2, 1});
    const auto& nodes = solid.elements.nodes;
    CHECK((nodes.col(0).array() - 0.09).abs().minCoeff() < 1e-12);
    CHECK((nodes.col(0).array() + 0.09).abs().minCoeff() < 1e-12);
    for (const auto& element : solid.elements.tetrahedra.rowwise())
        for (std::size_t e = 0; e < tetrahedronEdges.size(); ++e) {
            const auto [a, b] = tetrahedronEdges[e];
            const Eigen::RowVector3d middle = (nodes.row(element(a)) + nodes.row(element(b))) / 2;
            CHECK((nodes.row(element(static_cast<Eigen::Index>(4 + e))) - middle).norm() < 1e-14);
        }
}

TEST_CASE("The outline is closed, looks outward and lists the top's vertices first") {
    const SolidBar solid = solidBar(bar, {16, 4, 2});
    const BarOutline& outline = solid.outline;
    CHECK(isClosed(uniqueEdges(outline.mesh)));
    CHECK_THAT(signedVolumeM3(outline.mesh), WithinRel(signedVolumeM3(solid.surface), 0.03));
    REQUIRE(outline.topCount == 27);
    CHECK(std::is_sorted(outline.surfaceVertices.begin(),
                         outline.surfaceVertices.begin() + outline.topCount));
    for (std::size_t k = 0; k < outline.surfaceVertices.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        CHECK(outline.mesh.vertices.row(row) ==
              solid.surface.vertices.row(outline.surfaceVertices[k]));
        CHECK((outline.mesh.vertices(row, 2) == 0) == (row < outline.topCount));
    }
}
