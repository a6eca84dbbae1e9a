#include "Geometry/Remesh.h"

#include "Geometry/MeshCheck.h"
#include "Geometry/ParametricMesh.h"
#include "Geometry/TestMeshes.h"
#include "Mesh/SurfaceQuery.h"
#include "Support/GeneratedMeshes.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <random>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Returns the share of edges between 4/5 and 4/3 of a length, plus or minus a tenth.
double shareOfEdgesNear(const Mesh& mesh, double lengthMetres) {
    const auto edges = uniqueEdges(mesh);
    const auto isNear = [&](const MeshEdge& edge) {
        const double length = (mesh.vertices.row(edge.a) - mesh.vertices.row(edge.b)).norm();
        return length > 0.72 * lengthMetres && length < 1.47 * lengthMetres;
    };
    return static_cast<double>(std::ranges::count_if(edges, isNear)) /
           static_cast<double>(edges.size());
}

double greatestDistance(const Mesh& from, const Mesh& to) {
    const SurfaceQuery surface(to);
    double greatest = 0;
    for (const auto& vertex : from.vertices.rowwise())
        greatest = std::max(greatest, surface.nearestPoint(vertex.transpose()).distanceMetres);
    return greatest;
}

bool hasVertexAt(const Mesh& mesh, const Eigen::RowVector3d& point) {
    return (mesh.vertices.rowwise() - point).rowwise().norm().minCoeff() < 1e-12;
}

} // namespace

TEST_CASE("A ball is remeshed to near-equilateral triangles on its surface") {
    const auto ball = icosphereMesh(0.1, 4);
    for (const double edge : {0.004, 0.01, 0.03}) {
        const auto remeshed = remesh(ball, edge);
        REQUIRE(remeshed);
        CHECK(isOrientedManifold(*remeshed));
        CHECK(isClosed(uniqueEdges(*remeshed)));
        CHECK(shareOfEdgesNear(*remeshed, edge) > 0.9);
        CHECK(worstAspect(*remeshed) < 4);
        CHECK(greatestDistance(*remeshed, ball) < 1e-12);
        CHECK(checkMesh(*remeshed).isSolid());
    }
    const auto fine = remesh(ball, 0.004);
    CHECK(signedVolumeM3(*fine) == Approx(signedVolumeM3(ball)).epsilon(0.002));
}

TEST_CASE("A bar of twelve triangles keeps its corners and volume") {
    const Eigen::Vector3d size(0.35, 0.05, 0.02);
    const auto remeshed = remesh(boxMesh(size, {1, 1, 1}), 0.008);
    REQUIRE(remeshed);
    CHECK(isOrientedManifold(*remeshed));
    CHECK(signedVolumeM3(*remeshed) == Approx(size.prod()).epsilon(1e-9));
    CHECK(shareOfEdgesNear(*remeshed, 0.008) > 0.8);
    for (int corner = 0; corner < 8; ++corner)
        CHECK(hasVertexAt(*remeshed, {size.x() / 2 * ((corner & 1) != 0 ? 1 : -1),
                                      size.y() / 2 * ((corner & 2) != 0 ? 1 : -1),
                                      size.z() / 2 * ((corner & 4) != 0 ? 1 : -1)}));
}

TEST_CASE("A finely divided plate is coarsened and keeps its volume") {
    const auto plate = boxMesh({0.3, 0.2, 0.003}, {150, 100, 2});
    const auto remeshed = remesh(plate, 0.01);
    REQUIRE(remeshed);
    CHECK(remeshed->vertexCount() < plate.vertexCount() / 5);
    CHECK(isClosed(uniqueEdges(*remeshed)));
    CHECK(signedVolumeM3(*remeshed) == Approx(0.3 * 0.2 * 0.003).epsilon(1e-9));
}

TEST_CASE("An open sheet keeps its boundary and its corners") {
    const auto sheet = gridPlateMesh(0.4, 0.1, 3, 50);
    const auto remeshed = remesh(sheet, 0.01);
    REQUIRE(remeshed);
    CHECK(isOrientedManifold(*remeshed));
    CHECK(faceAreas(*remeshed).sum() == Approx(0.04).epsilon(1e-9));
    CHECK(shareOfEdgesNear(*remeshed, 0.01) > 0.9);
    CHECK(vertexNormals(*remeshed).col(2).minCoeff() > 0.999);
    for (const double x : {-0.2, 0.2})
        for (const double y : {-0.05, 0.05})
            CHECK(hasVertexAt(*remeshed, {x, y, 0}));
}

TEST_CASE("The walls of a bowl stay apart if the edge length exceeds the wall thickness") {
    const auto thin = bowl(0.1, 0.002, 30);
    const auto remeshed = remesh(thin, 0.006);
    REQUIRE(remeshed);
    CHECK(isClosed(uniqueEdges(*remeshed)));
    CHECK(greatestDistance(*remeshed, thin) < 1e-9);
    CHECK(signedVolumeM3(*remeshed) == Approx(signedVolumeM3(thin)).epsilon(0.02));
}

TEST_CASE("Size and position do not change a remeshing except for rounding") {
    const auto bar = boxMesh({0.35, 0.05, 0.02}, {7, 3, 2});
    const auto reference = remesh(bar, 0.01);
    for (const double scale : {1e-4, 1e4}) {
        auto other = bar;
        other.vertices *= scale;
        other.vertices.rowwise() += Eigen::RowVector3d(1, 2, 3) * scale;
        const auto remeshed = remesh(other, 0.01 * scale);
        REQUIRE(remeshed);
        CHECK(signedVolumeM3(*remeshed) / std::pow(scale, 3) == Approx(0.35 * 0.05 * 0.02));
        CHECK(meanEdgeLengthMetres(*remeshed) / scale ==
              Approx(meanEdgeLengthMetres(*reference)).epsilon(0.02));
    }
}

TEST_CASE("Surfaces that are not manifolds are cut apart and remeshed") {
    const auto cube = boxMesh({1, 1, 1}, {1, 1, 1});
    for (const auto& mesh : {joined(cube, moved(cube, {1, 1, 0})), moebiusStrip(30, 2), book(5),
                             kleinBottle(24, 16)}) {
        const auto remeshed = remesh(mesh, 0.15);
        REQUIRE(remeshed);
        CHECK(isOrientedManifold(*remeshed));
        CHECK(faceAreas(*remeshed).sum() == Approx(faceAreas(mesh).sum()).epsilon(0.03));
    }
}

TEST_CASE("Edges out of range and excessive sizes give an error with the reason") {
    const auto ball = icosphereMesh(0.1, 2);
    const auto errorOf = [&](double edgeLengthMetres) {
        return remesh(ball, edgeLengthMetres).error().message;
    };
    CHECK_THAT(errorOf(0), ContainsSubstring("edge length"));
    CHECK_THAT(errorOf(std::nan("")), ContainsSubstring("edge length"));
    CHECK_THAT(errorOf(1), ContainsSubstring("edge length"));
    CHECK_THAT(errorOf(std::nan("")), ContainsSubstring("edge length"));
    CHECK_THAT(errorOf(1e-5), ContainsSubstring("4000000 triangles"));
    auto broken = ball;
    broken.faces(3, 1) = 1 << 30;
    CHECK_THAT(remesh(broken, 0.1).error().message, ContainsSubstring("does not exist"));
    CHECK_THAT(remesh({}, 0.1).error().message, ContainsSubstring("no faces"));
}

TEST_CASE("A remeshing reports its progress and can be cancelled") {
    const auto ball = icosphereMesh(0.1, 3);
    std::vector<double> told;
    std::atomic<bool> cancelled = false;
    WorkControl control{.progress = [&](double f, std::string_view) { told.push_back(f); },
                        .cancelled = &cancelled};
    REQUIRE(remesh(ball, 0.01, control));
    CHECK(std::ranges::is_sorted(told));
    CHECK(told.size() == 6);
    CHECK(told.back() == 1);
    control.progress = [&](double f, std::string_view) { cancelled = f > 0.3; };
    const auto stopped = remesh(ball, 0.01, control);
    REQUIRE_FALSE(stopped);
    CHECK(stopped.error().message == cancelledMessage);
}

TEST_CASE("Remeshing a dense noisy scan gives a closed body of the same volume and the target edge "
          "length") {
    auto scan = icosphereMesh(1, 6);
    const double volumeM3 = checkMesh(scan).volumeM3;
    std::mt19937 random(1);
    std::normal_distribution<double> noiseMetres(0, 0.004); // edges are 20 mm long
    for (Eigen::Index v = 0; v < scan.vertexCount(); ++v)
        scan.vertices.row(v) *= 1 + noiseMetres(random);
    const auto covered = remesh(scan, 0.2);
    REQUIRE(covered);
    const auto check = checkMesh(*covered);
    CHECK(check.isSolid());
    CHECK(std::abs(check.volumeM3 / volumeM3 - 1) < 0.02);
    CHECK(std::abs(meanEdgeLengthMetres(*covered) / 0.2 - 1) < 0.15);
}

TEST_CASE("Remeshing fails if too many faces meet in one vertex") {
    CHECK(remesh(fanMesh(1000), 0.05));
    CHECK_THAT(remesh(fanMesh(30'000), 0.05).error().message,
               ContainsSubstring("too many of its faces meet in one vertex"));
}
