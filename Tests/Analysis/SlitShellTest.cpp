#include "Analysis/SlitShell.h"
#include "Geometry/ParametricMesh.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <set>

using namespace idiophone;
using Catch::Matchers::WithinRel;

namespace {

/// A box of 120 × 60 × 40 mm with walls of 4 mm, and a slit of 80 × 10 mm in one side.
SlitShell slitBox() {
    LatheMesh box{boxMesh({0.12, 0.06, 0.04}, {6, 4, 4}), {}};
    box.thicknessMetres = Eigen::VectorXd::Constant(box.mesh.vertexCount(), 0.004);
    return slitShell(box, [](const Eigen::RowVector3d& middle) {
        return middle.y() > 0.0299 && middle.z() > 0 && middle.z() < 0.01 &&
               std::abs(middle.x()) < 0.04;
    });
}

} // namespace

TEST_CASE("A slit shell measures its cavity and its mouth") {
    const auto box = slitBox();
    CHECK(box.closed.mesh.faceCount() - box.open.faceCount() == 8);
    CHECK_THAT(box.cavity.mouthM2, WithinRel(0.0008, 1e-9));
    CHECK_THAT(box.cavity.mouthLengthMetres, WithinRel(0.08, 1e-9));
    CHECK_THAT(box.cavity.wallMetres, WithinRel(0.004, 1e-9));
    CHECK_THAT(box.cavity.volumeM3, WithinRel(0.116 * 0.056 * 0.036, 0.03));
    CHECK((box.mouthMetres - Eigen::Vector3d(0, 0.03, 0.005)).norm() < 1e-9);
    std::set<int> used(box.open.faces.data(), box.open.faces.data() + box.open.faces.size());
    CHECK(static_cast<int>(used.size()) == box.open.vertexCount());
}

TEST_CASE("A solved slit shell has shapes outside, radiation, and modes that the air damps") {
    const auto box = slitBox();
    const auto object = solveSlitShell(box, *findMaterial("Maple"),
                                       {.name = "box",
                                        .source = "a test",
                                        .maxFrequencyHz = 3500,
                                        .shapeVertices = {0, 5, 9},
                                        .radiation = RadiationMethod::preview});
    REQUIRE(object);
    CHECK(validated(*object));
    CHECK(object->shapeVertexCount() == 3);
    CHECK(object->radiation.directions.size() == 2);
    for (std::size_t mode = 0; mode < object->modeCount(); ++mode)
        CHECK(object->decayPerSecond(mode) >
              object->material.damping.perSecond(object->eigenvalues[mode]) / 2);
}
