// Tests a shell whose thickness changes while it sounds.
#include "Support/PoleFit.h"
#include "Synth/ModalReference.h"

#include <algorithm>
#include <array>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double sampleRate = 48000;

/// One pure membrane mode, one pure bending mode, and one that is half of each.
ModalObject shell() {
    ModalObject object = syntheticObject({300, 1000, 4000});
    object.bending = {0, object.eigenvalues[1], object.eigenvalues[2] / 2};
    return object;
}

std::vector<float> rendered(const ModalObject& object, double thicknessRatio) {
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    auto settings = exactSettings();
    settings.thicknessRatio = thicknessRatio;
    synthesiser.setSettings(settings);
    return render(synthesiser, {{0, unitStrike()}}, static_cast<int>(0.4 * sampleRate / 64));
}

double foundHz(std::span<const float> signal, double nearHz) {
    return fitPole(signal, sampleRate, nearHz, 0.1).frequencyHz;
}

} // namespace

TEST_CASE("Twice the thickness keeps a membrane mode and raises a bending mode by an octave") {
    const auto output = rendered(shell(), 2);
    CHECK(foundHz(output, 300) == Approx(300).epsilon(1e-4));
    CHECK(foundHz(output, 2000) == Approx(2000).epsilon(1e-4));
    const double half = 4000 * std::sqrt(0.5 + 0.5 * 4);
    CHECK(foundHz(output, half) == Approx(half).epsilon(1e-4));
}

TEST_CASE(
    "A shell of half the thickness has half the mass, so the same strike moves it twice as much") {
    auto object = syntheticObject({300});
    object.bending = {0};
    const auto own = rendered(object, 1), thinner = rendered(object, 0.5);
    for (std::size_t i = 0; i < own.size(); ++i)
        REQUIRE(thinner[i] == Approx(2 * own[i]).margin(1e-6));
}

TEST_CASE("When modes swap order as a shell thickens, contact times stay clear of their periods") {
    auto object = syntheticObject({200, 215});
    object.bending = {object.eigenvalues[0], 0};
    object.material.damping = {};
    for (const double hz : {215.0, 400.0}) { // frequencies at twice the thickness
        Synthesiser synthesiser({slotOf(object)}, sampleRate);
        auto settings = exactSettings();
        settings.thicknessRatio = 2;
        synthesiser.setSettings(settings);
        auto strike = unitStrike();
        strike.durationSeconds = 1 / hz;
        const auto output = render(synthesiser, {{cellSamples, strike}}, 40);
        const auto loudest = std::ranges::max(output, {}, [](float x) { return std::abs(x); });
        CHECK(std::isfinite(loudest));
        CHECK(std::abs(loudest) < 10);
    }
}

TEST_CASE("Thickness changes nothing for solids or when it is out of range") {
    const auto solid = syntheticObject({300, 1000});
    CHECK(rendered(solid, 3) == rendered(solid, 1));
    CHECK(rendered(shell(), -1) == rendered(shell(), 1));
    CHECK(rendered(shell(), 1000) == rendered(shell(), 1));
}

TEST_CASE("A thickness that moves and returns leaves the pitch unchanged") {
    Synthesiser synthesiser({slotOf(shell())}, sampleRate);
    auto settings = exactSettings();
    const std::array ratios{1.5, 0.7, 3.0, 1.0};
    const auto output = render(synthesiser, {{4 * cellSamples, unitStrike()}},
                               static_cast<int>(0.4 * sampleRate / 64), [&](int cell) {
                                   if (cell >= static_cast<int>(ratios.size()))
                                       return;
                                   settings.thicknessRatio = ratios[static_cast<std::size_t>(cell)];
                                   synthesiser.setSettings(settings);
                               });
    CHECK(foundHz(output, 1000) == Approx(1000).epsilon(1e-4));
}

TEST_CASE("A slot that was silent while its thickness moved starts at the last thickness") {
    // The modes are close, so that groups merge and split on the way.
    std::vector<double> hz;
    for (int k = 0; k < 60; ++k)
        hz.push_back(400 * std::pow(1.03, k));
    auto object = syntheticObject(hz);
    for (std::size_t k = 0; k < hz.size(); ++k)
        object.bending.push_back(object.eigenvalues[k] * static_cast<double>(k % 4) / 4);
    const auto struckAfter = [&](const std::vector<double>& way, double last) {
        Synthesiser synthesiser({slotOf(object)}, sampleRate);
        SynthesisSettings settings;
        const auto goTo = [&](double ratio, double size) {
            settings.thicknessRatio = ratio;
            settings.sizeRatio = size; // moves poles too
            synthesiser.setSettings(settings);
        };
        for (const double ratio : way) {
            goTo(ratio, 1);
            render(synthesiser, {}, 1);
        }
        goTo(last, 1.1);
        return render(synthesiser, {{0, unitStrike(1e-3)}}, 40);
    };
    const auto expected = struckAfter({}, 1.25);
    CHECK(expected != struckAfter({}, 1));
    CHECK(struckAfter({0.5, 3, 0.8}, 1.25) == expected);
    CHECK(struckAfter({3, 1.25}, 1.25) == expected);
    CHECK(struckAfter({1.25, 0.3}, 1) == struckAfter({}, 1));
}
