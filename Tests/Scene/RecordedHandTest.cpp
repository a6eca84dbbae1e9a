// Tests the path and the taps of a recorded hand between its moments.
#include "Scene/RecordedHand.h"
#include "Instrument/ObjectLibrary.h"

#include "Scene/FactoryScenes.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

using namespace idiophone;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// The factory scene's bell with another path and other taps.
class BellUnderHand {
public:
    BellUnderHand()
        : assets(SceneAssets::make(*findFactoryScene("Bell under a hand"), ObjectLibrary::shared())
                     .value()),
          recorded(*assets->scene().hand) {
        recorded.path = {{.seconds = 1, .pointMetres = {0, -0.07, 0}, .newtons = 2},
                         {.seconds = 3, .pointMetres = {0.04, -0.07, 0}, .newtons = 6},
                         {.seconds = 4, .pointMetres = {0.04, -0.07, 0}, .newtons = 0},
                         {.seconds = 5, .pointMetres = {0, -0.07, 0}, .newtons = 0}};
        recorded.taps = {{.seconds = 0.5, .pointMetres = {0, -0.07, 0}, .metresPerSecond = 1},
                         {.seconds = 0.75, .pointMetres = {0, -0.07, 0}, .metresPerSecond = 32}};
    }

    const SceneAssets::Role& bell() const { return assets->roles()[recorded.kind]; }
    const SceneAssets::Role& tool() const { return assets->roles()[recorded.tool]; }

    std::shared_ptr<const SceneAssets> assets;
    Hand recorded;
};

} // namespace

TEST_CASE("Between two moments, the place and the force of a hand are linear") {
    const BellUnderHand scene;
    const RecordedHand hand(scene.recorded, scene.bell(), scene.tool());
    const auto touch = hand.touchAt(1.5, 7, 9);
    REQUIRE(touch);
    CHECK(touch->bodies == std::array<std::size_t, 2>{7, 9});
    CHECK_THAT(touch->forceNewtons, WithinAbs(3, 1e-12));
    CHECK_THAT(touch->slideMetresPerSecond, WithinAbs(0.02, 1e-12));
    CHECK(touch->rollMetresPerSecond == 0);
    CHECK((touch->pointMetres[0] - Eigen::Vector3d(0.01, -0.07, 0)).norm() < 1e-12);
    CHECK_THAT(touch->inward[0].norm(), WithinAbs(1, 1e-6));
    CHECK(touch->inward[1] == -touch->inward[0]);
}

TEST_CASE("A hand has no contact before its path, after it, or without force") {
    const BellUnderHand scene;
    const RecordedHand hand(scene.recorded, scene.bell(), scene.tool());
    for (const double seconds : {0.0, 0.999, 4.5, 5.0, 100.0})
        CHECK_FALSE(hand.touchAt(seconds, 0, 1));
    CHECK(hand.touchAt(1, 0, 1));
    CHECK(hand.touchAt(3.999, 0, 1));
}

TEST_CASE("Each tap is returned once, in its interval, with the Hertz contact time") {
    const BellUnderHand scene;
    const RecordedHand hand(scene.recorded, scene.bell(), scene.tool());
    CHECK(hand.tapsBetween(0, 0.5, 0, 1).empty());
    CHECK(hand.tapsBetween(0.500001, 0.75, 0, 1).empty());
    const auto both = hand.tapsBetween(0.5, 1, 3, 4);
    REQUIRE(both.size() == 2);
    CHECK(both[0].body == 3);
    CHECK(both[0].other == 4);
    CHECK_THAT(both[1].impulseNewtonSeconds.norm(),
               WithinRel(32 * both[0].impulseNewtonSeconds.norm(), 1e-9));
    CHECK_THAT(both[1].contactSeconds, WithinRel(both[0].contactSeconds / 2, 1e-9)); // ∝ v^(−1/5)
    const auto &bell = *scene.bell().kind.model, &tool = *scene.tool().kind.model;
    CHECK(both[0].contactSeconds == contactSeconds(bell, tool, tool.massKg, 1));
}
