// Tests the click of the rigid body in the synthesiser.
#include "Support/RigidBall.h"
#include "Synth/AccelerationNoise.h"
#include "Synth/Synthesiser.h"

#include <algorithm>
#include <array>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double rateHz = 48000;
constexpr float impulse = 0.05f;

using Stereo = std::array<std::vector<float>, 2>;

struct Impact {
    std::int64_t cell = 0;
    double sample = 0;
    float impulseNewtonSeconds = impulse;
    double contactSeconds = 1e-3;
    std::int32_t radiationDirection = -1;
};

Stereo rendered(const ModalObject& object,
                const SynthesisSettings& settings,
                const std::vector<Impact>& impacts,
                double slotSize = 1) {
    Synthesiser synthesiser({{std::make_shared<const ModalObject>(object), slotSize}}, rateHz, 2);
    synthesiser.setSettings(settings);
    Stereo sound;
    for (std::int64_t index = 0; index < 8; ++index) {
        std::array<float, cellSamples> left, right;
        const CellOutput cell(left, right);
        synthesiser.beginCell(cell);
        for (const Impact& impact : impacts)
            if (impact.cell == index)
                REQUIRE(
                    synthesiser.strike(0,
                                       {.point = {.radiationDirection = impact.radiationDirection},
                                        .impulseNewtonSeconds = {0, 0, impact.impulseNewtonSeconds},
                                        .durationSeconds = impact.contactSeconds},
                                       impact.sample, cell));
        sound[0].insert(sound[0].end(), left.begin(), left.end());
        sound[1].insert(sound[1].end(), right.begin(), right.end());
    }
    CHECK(synthesiser.silent());
    return sound;
}

float peak(const std::vector<float>& sound) {
    return std::abs(
        *std::ranges::max_element(sound, {}, [](float sample) { return std::abs(sample); }));
}

} // namespace

TEST_CASE("A struck ball with one silent mode sounds one cycle of a sine in each direction") {
    const auto ball = rigidBall(0.01, 7000);
    const Impact impact{.cell = 1, .sample = 20.25};
    const auto sound = rendered(ball, {.radiation = 1}, {impact});
    const std::array<float, 3> along{0, 0, impulse};
    const auto click = rigidClick(rigidRadiator(ball), along, impact.contactSeconds, 1, rateHz,
                                  {{{0, 0, 1}, {0, 0, 1}}});
    const double seconds = click.seconds;
    const double amplitude = click.pascalMetres[0];
    REQUIRE(amplitude > 1e-4);
    for (std::size_t k = 0; k < sound[0].size(); ++k) {
        const double turns =
            (static_cast<double>(k) - cellSamples - impact.sample) / rateHz / seconds;
        const double expected =
            turns > 0 && turns < 1 ? amplitude * std::sin(2 * std::numbers::pi * turns) : 0;
        REQUIRE(sound[0][k] == Approx(expected).margin(1e-5 * amplitude));
        REQUIRE(sound[1][k] == Approx(expected / 2).margin(1e-5 * amplitude));
    }
}

TEST_CASE("A contact microphone hears no click, and half the radiation gives half the click") {
    const auto ball = rigidBall(0.01, 7000);
    const std::vector<Impact> impacts{{.sample = 3}};
    CHECK(peak(rendered(ball, {.radiation = 0}, impacts)[0]) == 0);
    CHECK(peak(rendered(ball, {.radiation = 0.5}, impacts)[0]) ==
          Approx(peak(rendered(ball, {.radiation = 1}, impacts)[0]) / 2));
}

TEST_CASE("Clicks are proportional to the impulse and add up") {
    const auto ball = rigidBall(0.01, 7000);
    const SynthesisSettings far{.radiation = 1};
    const auto one = rendered(ball, far, {{.sample = 3}});
    const auto two = rendered(ball, far, {{.sample = 3, .impulseNewtonSeconds = 2 * impulse}});
    const auto both = rendered(ball, far, {{.sample = 3}, {.sample = 3}});
    for (std::size_t k = 0; k < one[0].size(); ++k) {
        REQUIRE(two[0][k] == Approx(2 * one[0][k]).margin(1e-9));
        REQUIRE(both[0][k] == Approx(2 * one[0][k]).margin(1e-9));
    }
}

TEST_CASE("A live material and size click like an object analysed with them") {
    const SynthesisSettings far{.radiation = 1};
    const std::vector<Impact> impacts{{.sample = 10.5, .contactSeconds = 3e-4}};
    const auto expected = rendered(rigidBall(0.02, 2500), far, impacts);
    auto heavy = rigidBall(0.01, 7500);
    SynthesisSettings live = far;
    live.sizeRatio = 0.5;
    live.material = liveMaterial(heavy.material);
    live.material->densityKgPerM3 = 2500;
    const auto sound = rendered(heavy, live, impacts, 4);
    for (std::size_t k = 0; k < expected[0].size(); ++k)
        REQUIRE(sound[0][k] == Approx(expected[0][k]).margin(1e-6));
}

TEST_CASE("A strike with one direction makes the same click in both channels") {
    const auto ball = rigidBall(0.01, 7000);
    const auto sound = rendered(ball, {.radiation = 1}, {{.sample = 3, .radiationDirection = 1}});
    const auto usual = rendered(ball, {.radiation = 1}, {{.sample = 3}});
    CHECK(sound[0] == usual[1]);
    CHECK(sound[1] == usual[1]);
}

TEST_CASE("An ideal impulse on a tiny ball clicks with its full spectrum below the band edge") {
    // The dipole moment, Σ t p(t), of a click depends on the impulse alone.
    const auto moment = [](double contactSeconds, double sample) {
        const auto sound =
            rendered(rigidBall(0.001, 7000), {.radiation = 1},
                     {{.cell = 1, .sample = sample, .contactSeconds = contactSeconds}});
        double sum = 0;
        for (std::size_t k = 0; k < sound[0].size(); ++k)
            sum +=
                (static_cast<double>(k) - cellSamples - sample) * static_cast<double>(sound[0][k]);
        return sum;
    };
    const double slow = moment(1e-3, 0);
    for (const double sample : {0.0, 0.25, 0.5, 0.75})
        CHECK(20 * std::log10(moment(0, sample) / slow) == Approx(0).margin(2.2));
}
