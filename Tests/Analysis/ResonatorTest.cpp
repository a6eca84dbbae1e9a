#include "Analysis/Resonator.h"
#include "Support/SyntheticObject.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

using namespace idiophone;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;
constexpr Resonator tube{
    .frequencyHz = 200, .radiusMetres = 0.025, .offsetMetres = 0, .gapMetres = 0.01};
constexpr double bodyAreaM2 = 0.05;
constexpr float barWeight = 1e-4f;

/// A sheet whose modes move as one, which has the tube's mouth under its middle.
ModalObject sheet(const std::vector<double>& frequenciesHz, std::vector<float> gains = {}) {
    auto object = test::syntheticObject(frequenciesHz, std::move(gains));
    object.vertices = {-1, 0, 0, 1, 0, 0, 1, 1, 0, -1, 1, 0};
    object.radiation = {.directions = {{0, 0, 1}},
                        .frequencyRatios = {0.5, 2},
                        .weights = std::vector<float>(2 * frequenciesHz.size(), barWeight)};
    return object;
}

ModalObject withTube(ModalObject object) {
    addResonator(object, tube, bodyAreaM2);
    return object;
}

double addedDecay(const ModalObject& object, std::size_t mode) {
    return object.decaysPerSecond[mode] -
           object.material.damping.perSecond(object.eigenvalues[mode]) / 2;
}

} // namespace

TEST_CASE("A tube opposes least at its own frequency and the odd multiples") {
    for (const double odd : {1.0, 3.0, 5.0}) {
        const double there = std::abs(tube.relativeImpedance(odd * tube.frequencyHz));
        INFO("partial " << odd);
        for (const double aside : {-0.2, 0.2})
            CHECK(std::abs(tube.relativeImpedance((odd + aside) * tube.frequencyHz)) > 2 * there);
    }
    CHECK(tube.flowGain(tube.frequencyHz) > 1.5);
    CHECK(tube.flowGain(2 * tube.frequencyHz) < 0.01 * tube.flowGain(tube.frequencyHz));
}

TEST_CASE(
    "The farther the bar, the less it drives the tube: far off, half the mouth over the gap") {
    Resonator far = tube;
    for (const double gapMetres : {0.0, 0.01, 0.03, 0.1}) {
        far.gapMetres = gapMetres + 0.01;
        CHECK(far.drive(200) < Resonator{.radiusMetres = 0.025, .gapMetres = gapMetres}.drive(200));
    }
    far.gapMetres = 1;
    CHECK_THAT(far.drive(200), WithinRel(2 * pi * 200 / 343 * 0.025 * 0.0125, 1e-3));
}

TEST_CASE("At resonance a tube's resistance is pi/4Q, with Q of wall and radiation together") {
    const double waveNumber = 2 * pi * tube.frequencyHz / 343;
    const double wall = 2 * 3e-5 * std::sqrt(tube.frequencyHz) / tube.radiusMetres / waveNumber;
    const double radiated = std::pow(waveNumber * tube.radiusMetres, 2) / pi;
    CHECK_THAT(tube.relativeImpedance(tube.frequencyHz).real(),
               WithinRel(pi / 4 * (wall + radiated), 1e-3));
}

TEST_CASE("What a tube radiates is what it takes from the mode less what its wall keeps") {
    const auto object = withTube(sheet({200, 330, 600}, {2, 3, 1.5f}));
    for (std::size_t mode = 0; mode < 3; ++mode) {
        const double omega = std::sqrt(object.eigenvalues[mode]), hz = omega / (2 * pi);
        const double flow =
            std::sqrt(std::pow(object.radiation.weights[mode], 2) - std::pow(barWeight, 2)) *
            bodyAreaM2;
        const double radiated = 1.204 * std::pow(omega * flow, 2) / (8 * pi * 343);
        const double throughMouth = std::pow(omega / 343 * tube.radiusMetres, 2) / 4;
        const double share = throughMouth / tube.relativeImpedance(hz).real();
        INFO(hz << " Hz");
        CHECK(share < 1);
        CHECK_THAT(addedDecay(object, mode), WithinRel(radiated / share, 1e-4));
    }
}

TEST_CASE("Partials at odd multiples ring shorter, those between as before") {
    const auto object = withTube(sheet({200, 400, 600, 800}));
    for (const std::size_t odd : {0, 2})
        for (const std::size_t even : {1, 3})
            CHECK(addedDecay(object, odd) > 50 * addedDecay(object, even));
}

TEST_CASE("A blow on the middle drives what the tube adds the way it is heard there") {
    for (const float gain : {2.0f, -2.0f}) {
        const auto object = withTube(sheet({200}, {gain}));
        const float pushedDown = -gain;
        for (const float weight : object.radiation.weights)
            CHECK(pushedDown * weight > 0);
    }
}

TEST_CASE("A bar that is louder than its tube keeps its sign, and powers add") {
    auto loud = sheet({400});
    loud.radiation.weights.assign(2, 0.3f);
    const auto tubeAlone = withTube(sheet({400})).radiation.weights[0];
    const auto both = withTube(std::move(loud)).radiation.weights[0];
    CHECK(both >= 0.3f);
    CHECK_THAT(both, WithinAbs(std::hypot(0.3, tubeAlone), 1e-6));
}

TEST_CASE("A tube is cut a quarter of a wave long, less the end correction") {
    CHECK_THAT(tubeLengthMetres(tube), WithinRel(343.0 / 800 - 0.61 * 0.025, 1e-12));
}
