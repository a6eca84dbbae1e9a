#include "Analysis/CurvedEdges.h"

#include "Analysis/QuadraticTetrahedra.h"
#include "Geometry/ParametricMesh.h"
#include "TestMaterials.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;

namespace {

double curvedVolumeM3(const TetMesh& mesh) {
    const auto law = elasticLaw(referenceWood());
    double sum = 0;
    for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t)
        sum += elementIntegrals(nodesOf(mesh, t), law).volumeM3;
    return sum;
}

TetMesh filled(const Mesh& surface) {
    auto mesh = tetrahedralise(surface, {.targetEdgeMetres = 0.1});
    REQUIRE(mesh);
    return std::move(*mesh);
}

} // namespace

TEST_CASE("Curved elements of a coarse ball have the volume of the fine ball") {
    const Mesh coarse = icosphereMesh(0.1, 2);
    auto mesh = filled(coarse);
    const double exact = 4.0 / 3 * std::numbers::pi * 1e-3;
    CHECK(volumeM3(mesh) < 0.97 * exact);
    curveEdges(mesh, coarse, SurfaceQuery(icosphereMesh(0.1, 5)));
    CHECK_THAT(curvedVolumeM3(mesh), WithinRel(exact, 0.003));
}

TEST_CASE("A body with plane faces keeps its straight edges") {
    const Mesh box = boxMesh({0.3, 0.2, 0.1}, {3, 2, 1});
    auto mesh = filled(box);
    const Eigen::MatrixXd straight = mesh.nodes;
    curveEdges(mesh, box, SurfaceQuery(boxMesh({0.3, 0.2, 0.1}, {7, 5, 2})));
    CHECK(mesh.nodes == straight);
}

TEST_CASE("An element that would lose most of its volume stays straight") {
    const Mesh box = boxMesh({0.3, 0.2, 0.1}, {3, 2, 1});
    auto mesh = filled(box);
    curveEdges(mesh, box, SurfaceQuery(boxMesh({0.3, 0.2, 0.05}, {3, 2, 1})));
    for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t)
        CHECK(leastVolumeShare(nodesOf(mesh, t)) >= 0.3);
}

TEST_CASE("Edges do not jump to a surface far away") {
    const Mesh box = boxMesh({0.3, 0.2, 0.1}, {3, 2, 1});
    auto mesh = filled(box);
    const Eigen::MatrixXd straight = mesh.nodes;
    curveEdges(mesh, box, SurfaceQuery(boxMesh({0.21, 0.11, 0.01}, {3, 2, 1})));
    CHECK(mesh.nodes == straight);
}
