#include "Analysis/BarTuning.h"

#include "Analysis/FactoryBars.h"
#include "Geometry/MeshCheck.h"
#include "TestMaterials.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

BarSpecification smallBar(double secondRatio, double thirdRatio) {
    return {.name = "one",
            .shape = {.lengthMetres = 0,
                      .widthMetres = 0.035,
                      .heightMetres = 0.02,
                      .centreHeightMetres = 0.01,
                      .endHeightMetres = 0.02,
                      .archHalfLengthShare = 0.35},
            .targets = {.fundamentalHz = 500, .secondRatio = secondRatio, .thirdRatio = thirdRatio},
            .material = referenceWood(0.25),
            .maxFrequencyHz = 8000};
}

} // namespace

TEST_CASE("Tuning corrects the audible pitch for damping, which shifts it by 0.9 cents") {
    auto bar = smallBar(0, 0);
    bar.targets.fundamentalHz = 1000;
    bar.material.damping.fluidPerSecond = 400;
    const auto tuned = tuneBar(bar);
    REQUIRE(tuned);
    const auto mode = static_cast<std::size_t>(tuned->bendingModes.at(0));
    const double lambda = tuned->object.eigenvalues.at(mode);
    const double alpha = bar.material.damping.perSecond(lambda) / 2;
    const double heard = std::sqrt(lambda - alpha * alpha) / (2 * std::numbers::pi);
    CHECK_THAT(cents(heard, 1000), WithinAbs(0, fundamentalToleranceCents));
    CHECK(cents(std::sqrt(lambda) / (2 * std::numbers::pi), heard) > 0.8);
    CHECK_THAT(tuned->partialsHz[0], WithinRel(heard, 1e-9));
    CHECK(tuned->object.bandHz == 8000);
}

TEST_CASE("Partials of 1:3, 1:4 and 1:4:10 are reached in the finite-element modes") {
    struct Ratios {
        double second, third;
    };
    for (const auto& [second, third] : {Ratios{3, 0}, Ratios{4, 0}, Ratios{4, 10}}) {
        const auto tuned = tuneBar(smallBar(second, third));
        REQUIRE(tuned);
        REQUIRE(tuned->partialsHz.size() >= 3);
        CHECK_THAT(cents(tuned->partialsHz[0], 500), WithinAbs(0, fundamentalToleranceCents));
        CHECK_THAT(cents(tuned->partialsHz[1], 500 * second), WithinAbs(0, partialToleranceCents));
        if (third > 0)
            CHECK_THAT(cents(tuned->partialsHz[2], 500 * third),
                       WithinAbs(0, partialToleranceCents));
    }
}

TEST_CASE("The object has the bar's outline with shapes on top, and the surface to cut is solid") {
    const auto tuned = tuneBar(smallBar(3, 0));
    REQUIRE(tuned);
    const auto& object = tuned->object;
    CHECK(object.shapeVertexCount() == 51);
    CHECK(object.vertexCount() == 85);
    for (const auto vertex : object.shapeVertices)
        CHECK(object.vertices[3 * static_cast<std::size_t>(vertex) + 2] == 0.0f);
    const MeshCheck check = checkMesh(tuned->surface);
    CHECK(check.isSolid());
    const double density = tuned->object.material.densityKgPerM3;
    CHECK_THAT(object.mass.massKg, WithinRel(check.volumeM3 * density, 1e-9));
}

TEST_CASE("Bars that cannot be tuned give an error that names them") {
    auto bar = smallBar(0, 0);
    bar.name = "odd";
    bar.targets.fundamentalHz = 30000;
    CHECK_THAT(tuneBar(bar).error().message, ContainsSubstring("\"odd\""));
    bar = smallBar(0, 0);
    bar.shape.widthMetres = -1;
    CHECK_FALSE(tuneBar(bar));
    bar = smallBar(0, 0);
    bar.material = {};
    CHECK_FALSE(tuneBar(bar));
    CHECK_THAT(tuneBar(smallBar(12, 0)).error().message, ContainsSubstring("12"));
    const std::atomic<bool> cancelled = true;
    CHECK(tuneBar(smallBar(0, 0), {.progress = {}, .cancelled = &cancelled}).error().message ==
          cancelledMessage);
}
