#include "Analysis/BarTuning.h"

#include "Geometry/ParametricMesh.h"
#include "TestMaterials.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("A bar tuned to 1000 Hz sounds within 0.05 cent of it, damping and all") {
    auto material = referenceWood(1.0 / 3);
    material.damping.fluidPerSecond = 400; // enough to be heard in the pitch: -1.8 cents
    const BarSpecification bar{.name = "one",
                               .targetFrequencyHz = 1000,
                               .widthMetres = 0.035,
                               .heightMetres = 0.02,
                               .material = material,
                               .vertexCount = 500};
    const auto tuned = tuneBar(bar);
    REQUIRE(tuned);
    const auto mode = static_cast<std::size_t>(tuned->bendingMode);
    const double lambda = tuned->object.eigenvalues.at(mode);
    const double alpha =
        (material.damping.fluidPerSecond + material.damping.viscoelasticSeconds * lambda) / 2;
    const double heard = std::sqrt(lambda - alpha * alpha) / (2 * std::numbers::pi);
    CHECK_THAT(cents(heard, 1000), WithinAbs(0, 0.05));
    CHECK(cents(std::sqrt(lambda) / (2 * std::numbers::pi), 1000) > 0.5);
    CHECK_THAT(tuned->fundamentalHz, WithinRel(heard, 1e-6));
    CHECK(tuned->object.bandHz == 44000);
}

TEST_CASE("The estimated length of a slender bar is Euler-Bernoulli's, of a thick one shorter") {
    BarSpecification bar{.name = "bar",
                         .targetFrequencyHz = 100,
                         .heightMetres = 0.005,
                         .material = referenceWood()};
    const auto slender = [&] {
        return std::sqrt(1.02792 * bar.heightMetres * std::sqrt(20e9 / 1000) /
                         bar.targetFrequencyHz);
    };
    CHECK_THAT(estimatedBarLengthMetres(bar), WithinRel(slender(), 0.001));
    bar.targetFrequencyHz = 569.6; // the bar of REFERENCE 1.3
    bar.heightMetres = 0.02;
    CHECK_THAT(estimatedBarLengthMetres(bar), WithinRel(0.4, 0.002));
    CHECK(estimatedBarLengthMetres(bar) < slender());
}

TEST_CASE("The chosen vertices of a sheet cover it evenly with its corners, ends and middle") {
    const double length = 0.3, width = 0.04;
    const auto sheet = sheetMesh(length, width, 1000);
    const auto chosen = evenSheetVertices(sheet, length, width, 285);
    CHECK(std::abs(static_cast<int>(chosen.size()) - 285) < 40);
    const auto nearest = [&](double x, double y) {
        double best = 1e9;
        for (const int v : chosen)
            best = std::min(best, (sheet.vertices.row(v) - Eigen::RowVector3d(x, y, 0)).norm());
        return best;
    };
    for (const double x : {-length / 2, length / 2})
        for (const double y : {-width / 2, width / 2})
            CHECK(nearest(x, y) < 1e-9);
    CHECK(nearest(0, 0) < 1e-9);
    for (int i = 0; i <= 100; ++i)
        for (int j = 0; j <= 20; ++j)
            REQUIRE(nearest((i / 100.0 - 0.5) * length, (j / 20.0 - 0.5) * width) < 0.008);
}

TEST_CASE("Bars that cannot be tuned are refused with a sentence") {
    BarSpecification bar{.name = "odd", .material = referenceWood()};
    bar.targetFrequencyHz = 30000;
    CHECK_THAT(tuneBar(bar).error().message, Catch::Matchers::ContainsSubstring("\"odd\""));
    bar.targetFrequencyHz = 440;
    bar.widthMetres = -1;
    CHECK_FALSE(tuneBar(bar));
    bar = {.name = "flat", .material = {}};
    CHECK_FALSE(tuneBar(bar));
    const std::atomic<bool> cancelled = true;
    bar = {.name = "stop", .material = referenceWood()};
    CHECK(tuneBar(bar, {.progress = {}, .cancelled = &cancelled}).error().message ==
          cancelledMessage);
}
