#include "Geometry/LatheMesh.h"
#include "Geometry/SpreadVertices.h"

#include "Geometry/TurnedSections.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;

double smallestAngleDegrees(const Mesh& mesh) {
    double smallest = 180;
    for (const auto& face : mesh.faces.rowwise())
        for (int k = 0; k < 3; ++k) {
            const Eigen::RowVector3d at = mesh.vertices.row(face(k));
            const Eigen::RowVector3d a = (mesh.vertices.row(face((k + 1) % 3)) - at).normalized();
            const Eigen::RowVector3d b = (mesh.vertices.row(face((k + 2) % 3)) - at).normalized();
            smallest = std::min(smallest, std::acos(a.dot(b)) * 180 / pi);
        }
    return smallest;
}

int boundaryEdges(const Mesh& mesh) {
    int count = 0;
    for (const auto& edge : uniqueEdges(mesh))
        count += edge.faceCount == 1 ? 1 : 0;
    return count;
}

std::vector<LathePoint> halfCircle(double radiusMetres) {
    std::vector<LathePoint> section;
    for (int k = 0; k <= 200; ++k) {
        const double angle = pi * k / 200;
        section.push_back({k == 0 || k == 200 ? 0 : radiusMetres * std::sin(angle),
                           -radiusMetres * std::cos(angle), 0.001});
    }
    return section;
}

} // namespace

TEST_CASE("A turned half circle is a closed sphere with the right area and volume") {
    const auto sphere = latheMesh(halfCircle(0.1), 0.008).mesh;
    CHECK(isClosed(uniqueEdges(sphere)));
    CHECK_THAT(faceAreas(sphere).sum(), WithinRel(4 * pi * 0.01, 0.01));
    CHECK_THAT(signedVolumeM3(sphere), WithinRel(4.0 / 3 * pi * 0.001, 0.01));
}

TEST_CASE("No triangle of a turned bowl has an angle under 30 degrees, even at the pole") {
    const double edge = GENERATE(0.005, 0.008, 0.013);
    const auto bowl = latheMesh(bowlSection({.rimRadiusMetres = 0.083,
                                             .heightMetres = 0.073,
                                             .footRadiusMetres = 0.035,
                                             .footThicknessMetres = 0.005,
                                             .rimThicknessMetres = 0.004}),
                                edge);
    CHECK(smallestAngleDegrees(bowl.mesh) > 30);
    CHECK_THAT(meanEdgeLengthMetres(bowl.mesh), WithinRel(edge, 0.1));
    CHECK(connectedComponents(bowl.mesh).count == 1);
}

TEST_CASE("A turned surface has twelve-fold symmetry") {
    const auto cap = latheMesh(capSection(0.178, 0.1, 0.002), 0.013).mesh;
    const double angle = pi / 6;
    for (const auto& vertex : cap.vertices.rowwise()) {
        if (vertex.head<2>().norm() < 0.04)
            continue; // six vertices around the pole
        const Eigen::RowVector3d turned(vertex.x() * std::cos(angle) - vertex.y() * std::sin(angle),
                                        vertex.x() * std::sin(angle) + vertex.y() * std::cos(angle),
                                        vertex.z());
        REQUIRE((cap.vertices.rowwise() - turned).rowwise().norm().minCoeff() < 1e-12);
    }
}

TEST_CASE("A bell is open only at its lip and has the requested wall thickness") {
    const BellMeasures measures{.lipRadiusMetres = 0.07,
                                .heightMetres = 0.09,
                                .shoulderRadiusMetres = 0.045,
                                .shoulderCurveMetres = 0.014,
                                .lipThicknessMetres = 0.0035,
                                .sideThicknessMetres = 0.0025,
                                .crownThicknessMetres = 0.004};
    const auto bell = latheMesh(bellSection(measures), 0.007);
    const auto onLip = (bell.mesh.vertices.col(2).array() == 0).count();
    CHECK(boundaryEdges(bell.mesh) == onLip);
    CHECK(onLip % 24 == 0);
    CHECK_THAT(bell.mesh.vertices.leftCols(2).rowwise().norm().maxCoeff(), WithinRel(0.07, 1e-12));
    CHECK_THAT(bell.mesh.vertices.col(2).maxCoeff(), WithinRel(0.09, 1e-12));
    CHECK_THAT(bell.thicknessMetres.maxCoeff(), WithinRel(0.004, 1e-12));
    CHECK(bell.thicknessMetres.minCoeff() >= 0.0025 - 1e-12);
    for (Eigen::Index v = 0; v < bell.mesh.vertexCount(); ++v)
        if (bell.mesh.vertices(v, 2) == 0)
            REQUIRE(std::abs(bell.thicknessMetres(v) - 0.0035) < 1e-12);
}

TEST_CASE("A case has the requested height and radii and a flat base") {
    const auto mesh = latheMesh(caseSection({.baseRadiusMetres = 0.049,
                                             .mouthRadiusMetres = 0.045,
                                             .heightMetres = 0.292,
                                             .mouthHeightMetres = 0.028,
                                             .cornerMetres = 0.009,
                                             .baseThicknessMetres = 0.008,
                                             .wallThicknessMetres = 0.002,
                                             .mouthThicknessMetres = 0.0013}),
                                0.01)
                          .mesh;
    const Eigen::VectorXd radii = mesh.vertices.leftCols(2).rowwise().norm();
    CHECK_THAT(radii.maxCoeff(), WithinRel(0.049, 0.005));
    for (Eigen::Index v = 0; v < mesh.vertexCount(); ++v) {
        if (radii(v) < 0.039)
            REQUIRE(mesh.vertices(v, 2) == 0);
        if (mesh.vertices(v, 2) > 0.27)
            REQUIRE(std::abs(radii(v) - 0.045) < 1e-9);
    }
    CHECK_THAT(mesh.vertices.col(2).maxCoeff(), WithinRel(0.292, 1e-12));
}

TEST_CASE("Spread vertices are evenly spaced and leave no gap") {
    const auto mesh = latheMesh(halfCircle(0.1), 0.006).mesh;
    std::vector<int> northern;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        if (mesh.vertices(v, 2) > 0)
            northern.push_back(v);
    const auto spread = spreadVertices(mesh, northern, 60);
    REQUIRE(spread.size() == 60);
    CHECK(std::ranges::is_sorted(spread));
    double closest = 1, farthest = 0;
    for (const int candidate : northern) {
        double nearest = 1;
        for (const int chosen : spread) {
            const double distance =
                (mesh.vertices.row(candidate) - mesh.vertices.row(chosen)).norm();
            nearest = std::min(nearest, distance);
            if (candidate != chosen && std::ranges::binary_search(spread, candidate))
                closest = std::min(closest, distance);
        }
        farthest = std::max(farthest, nearest);
    }
    // Each vertex was the farthest from those chosen before it, and all others are nearer.
    CHECK(farthest <= closest * (1 + 1e-9));
    CHECK(spreadVertices(mesh, northern, 1u << 20) == northern);
    CHECK(spreadVertices(mesh, {}, 5).empty());
}

TEST_CASE("A smooth section passes through its points, and bends only where none is given twice") {
    constexpr LathePoint corner{0.05, 0.1, 0.003};
    constexpr LathePoint points[] = {{0.05, 0, 0.002}, corner, corner, {0.03, 0.12, 0.004}};
    const auto straight = smoothSection(points);
    for (const auto& point : points)
        CHECK(std::ranges::count(straight, point) >= 1);
    for (const auto& point : straight)
        if (point.heightMetres < 0.1)
            CHECK_THAT(point.radiusMetres, WithinRel(0.05, 1e-9));

    // Three points on a parabola, r = 0.05 − 4 (z − 0.05)², lie on a curve close to it.
    constexpr LathePoint bent[] = {{0.04, 0, 0.002}, {0.05, 0.05, 0.002}, {0.04, 0.1, 0.002}};
    for (const auto& point : smoothSection(bent)) {
        const double parabola = 0.05 - 4 * std::pow(point.heightMetres - 0.05, 2);
        CHECK(std::abs(point.radiusMetres - parabola) < 0.0025);
    }
}
