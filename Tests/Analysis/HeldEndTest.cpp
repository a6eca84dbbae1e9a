// Tests bars that are held at one end: where the clamp and the bridge are, and what cannot be
// tuned.
#include "Analysis/HeldEnd.h"

#include "Analysis/BarTuning.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <string>

using namespace idiophone;
using Catch::Matchers::WithinRel;

namespace {

constexpr UndercutBar bar{.lengthMetres = 0.06,
                          .widthMetres = 0.004,
                          .heightMetres = 0.001,
                          .centreHeightMetres = 0.001,
                          .endHeightMetres = 0.001};

} // namespace

TEST_CASE("A held end is clamped at its last section, and rests on its bridge with the underside") {
    const HeldEnd end{.backMetres = 0.01, .resistanceNsPerM = 100};
    const auto bridged = withBridge(bar, end);
    const auto support = supportOf(end, bridged);
    CHECK(support.resistanceNsPerM == 100);
    CHECK_FALSE(support.boardKgPerM2);
    CHECK(isClamped(support.clamps, {0.03, 0.001, 0}));
    CHECK_FALSE(isClamped(support.clamps, {0.029, 0, 0}));
    CHECK(isClamped(support.clamps, {0.02, -0.002, -0.001}));
    CHECK_FALSE(isClamped(support.clamps, {0.02, 0, -0.0005}));
    CHECK_FALSE(isClamped(support.clamps, {-0.02, 0, -0.001}));
    CHECK_FALSE(isClamped(supportOf({}, bar).clamps, {0.02, 0, -0.001}));
}

TEST_CASE("The estimated length is a cantilever's, and the part behind the bridge") {
    const BeamMaterial steel{.youngsModulusPa = 2e11, .densityKgPerM3 = 7850};
    // 0.16154 h √(E/ρ)/L² (Blevins 1979)
    const double freeMetres = std::sqrt(0.16154 * 0.001 * std::sqrt(2e11 / 7850) / 440);
    CHECK_THAT(estimatedLengthMetres({}, bar, steel, 440), WithinRel(freeMetres, 1e-4));
    CHECK_THAT(estimatedLengthMetres({.backMetres = 0.01}, bar, steel, 440),
               WithinRel(freeMetres + 0.01, 1e-4));
}

TEST_CASE("A held bar with a target for its second partial is refused") {
    const auto tuned = tuneBar({.name = "tine",
                                .shape = bar,
                                .targets = {.fundamentalHz = 440, .secondRatio = 4},
                                .material = *findMaterial("Mild steel"),
                                .held = HeldEnd{}});
    REQUIRE_FALSE(tuned);
    CHECK(tuned.error().message ==
          "The bar \"tine\" cannot be tuned: a bar that is held at one end "
          "has only its fundamental tuned");
}
