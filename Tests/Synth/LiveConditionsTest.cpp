#include "Synth/LiveConditions.h"

#include "Support/SyntheticObject.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

TEST_CASE("Without settings an object is as its reference") {
    const auto own = syntheticObject({100}).material;
    const auto live = liveConditions(own, {});
    CHECK(live.law == PoleLaw{1, own.damping});
    CHECK(live.gainRatio == 1);
    CHECK(live.radiationRatio == 1);
    CHECK(live.frequencyRatio() == 1);
}

TEST_CASE("Eigenvalues follow Y/ρ, size and tuning, gains 1/mass, radiation frequency times size") {
    const auto own = syntheticObject({100}).material;
    SynthesisSettings settings;
    settings.material = LiveMaterial{.youngsModulusPa = 8 * own.youngsModulusPa,
                                     .densityKgPerM3 = 2 * own.densityKgPerM3,
                                     .damping = {7, 3e-7, 2e-4}};
    settings.sizeRatio = 2;
    settings.frequencyRatio = 1.5;
    const auto live = liveConditions(own, settings, 3, 4);
    CHECK(live.frequencyRatio() == Approx(2 * 1.5 * 4 / 6));
    CHECK(live.law.damping == DampingLaw{7, 3e-7, 2e-4});
    CHECK(live.gainRatio == Approx(1 / (2 * 6.0 * 6 * 6)));
    CHECK(live.radiationRatio == Approx(2 * 1.5 * 4));
}

TEST_CASE("Modes sound from 20 Hz to below 0.49 of the sample rate") {
    const auto sounds = [](double hz) {
        const double omega = 2 * std::numbers::pi * hz;
        return soundsAt({.stiffness = omega * omega, .damping = 0}, 48000);
    };
    CHECK_FALSE(sounds(19.99));
    CHECK(sounds(20.01));
    CHECK(sounds(23519));
    CHECK_FALSE(sounds(23521));
}
