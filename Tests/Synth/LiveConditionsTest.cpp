#include "Synth/LiveConditions.h"

#include "Support/SyntheticObject.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

TEST_CASE("An object without settings keeps its reference conditions") {
    const auto own = syntheticObject({100}).material;
    const auto live = liveConditions(own, {});
    CHECK(live.law == PoleLaw{1, own.damping});
    CHECK(live.gainRatio == 1);
    CHECK(live.radiationRatio == 1);
    CHECK(live.frequencyRatio() == 1);
}

TEST_CASE("Eigenvalues, gains and radiation follow live material, size and tuning") {
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

TEST_CASE("Every mode decays in the time of the decay ratio, at its own frequency") {
    const auto own = syntheticObject({100}).material;
    const ModeDamping mode{.scale = 0.5, .extraPerSecond = 3};
    const double eigenvalue = 4e6;
    const auto before = liveConditions(own, {}).law.pole(eigenvalue, mode);
    for (const double ratio : {0.05, 8.0}) {
        const auto after = liveConditions(own, {.decayRatio = ratio}).law.pole(eigenvalue, mode);
        CHECK(after.stiffness == before.stiffness);
        CHECK(after.damping == Approx(before.damping / ratio));
    }
}

TEST_CASE("A kept pitch sounds at its damped frequency in any material, size and thickness") {
    const auto own = syntheticObject({100}).material;
    const double omega = 2 * std::numbers::pi * 200;
    const PitchMode pitch{.hz = 200,
                          .eigenvalue = omega * omega * 1.01,
                          .bending = omega * omega / 2,
                          .damping = {.scale = 1.5, .extraPerSecond = 4}};
    for (const double loss : {0.0, 0.01, 0.3})
        for (const double size : {0.1, 1.0, 10.0})
            for (const double thickness : {0.25, 1.0, 4.0}) {
                SynthesisSettings settings{.sizeRatio = size,
                                           .thicknessRatio = thickness,
                                           .frequencyRatio = 1.5,
                                           .decayRatio = size < 1 ? 0.5 : 2,
                                           .keepPitch = true};
                settings.material = LiveMaterial{.youngsModulusPa = 3 * own.youngsModulusPa,
                                                 .densityKgPerM3 = own.densityKgPerM3 / 5,
                                                 .damping = {20, 1e-5, loss}};
                const auto live = liveConditions(own, settings, 3, 0.75, &pitch);
                const double eigenvalue =
                    pitch.eigenvalue + (thickness * thickness - 1) * pitch.bending;
                const auto pole = live.law.pole(eigenvalue, pitch.damping);
                CHECK(dampedFrequency(pole) == Approx(omega * 1.5 * 0.75).epsilon(1e-9));
                CHECK(live.gainRatio == Approx(5 / std::pow(3 * size, 3)));
                CHECK(live.radiationRatio == Approx(live.frequencyRatio() * 3 * size));
                settings.keepPitch = false;
                CHECK(liveConditions(own, settings, 3, 0.75, &pitch).law ==
                      liveConditions(own, settings, 3, 0.75).law);
            }
}

TEST_CASE("A kept pitch leaves the reference unchanged under default settings") {
    const auto object = syntheticObject({100, 270});
    const PitchMode pitch{.hz = object.dampedFrequencyHz(1), .eigenvalue = object.eigenvalues[1]};
    const auto live = liveConditions(object.material, {.keepPitch = true}, 1, 1, &pitch);
    CHECK(live.law.eigenvalueRatio == Approx(1).epsilon(1e-13));
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
