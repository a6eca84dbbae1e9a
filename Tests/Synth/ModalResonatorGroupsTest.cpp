// Tests groups of merged modes that change while they sound.
#include "ModalReference.h"
#include "Synth/ModalResonator.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRate = 48000;

SynthesisSettings settingsOf(double fluidDamping, double compression = 1) {
    SynthesisSettings settings = exactSettings();
    settings.compression = compression;
    settings.material = LiveMaterial{1e10, 1000, {fluidDamping, 0}};
    return settings;
}

/// The sound that a second strike at cell 40 adds, after the settings became `now` at cell 20.
struct Struck {
    std::vector<float> sound;
    std::int32_t modes = 0;
};

Struck secondStrike(const ModalObject& object,
                    const SynthesisSettings& before,
                    const SynthesisSettings& now) {
    Struck result;
    for (const bool second : {true, false}) {
        Synthesiser synthesiser({slotOf(object)}, sampleRate);
        std::vector<TimedStrike> strikes{{0, unitStrike()}};
        if (second)
            strikes.push_back({40 * cellSamples + 5.5, unitStrike(1e-3)});
        const auto output = render(synthesiser, strikes, 400, [&](int cell) {
            synthesiser.setSettings(cell < 20 ? before : now);
        });
        if (second)
            result = {output, synthesiser.status()[0].modesRinging};
        else
            for (std::size_t k = 0; k < output.size(); ++k)
                result.sound[k] -= output[k];
    }
    return result;
}

/// 60 different modes between 200 and 241 Hz.
ModalObject denseObject() {
    std::vector<double> frequencies;
    std::vector<float> gains;
    for (int k = 0; k < 60; ++k) {
        frequencies.push_back(200 + 0.7 * k);
        gains.push_back(0.3f + 0.01f * static_cast<float>(k * 37 % 60));
    }
    return ringingObject(frequencies, 2, gains);
}

} // namespace

TEST_CASE("The same settings give the same groups and strike sound, whatever was set before") {
    const ModalObject object = ringingObject({1000, 1002.5, 1005, 1900, 1901, 2700}, 1);
    const SynthesisSettings apart = settingsOf(1);
    const SynthesisSettings merged = settingsOf(60);
    for (const auto& [before, now, modes] :
         {std::tuple(apart, merged, 4), std::tuple(merged, apart, 6),
          std::tuple(settingsOf(60, 0), merged, 4), std::tuple(merged, settingsOf(60, 0), 6)}) {
        const Struck reached = secondStrike(object, before, now);
        const Struck always = secondStrike(object, now, now);
        CHECK(always.modes == modes);
        CHECK(reached.modes == modes);
        CHECK(errorDb(reached.sound, [&](double n) {
                  return double(always.sound[static_cast<std::size_t>(n)]);
              }) < -105);
    }
}

TEST_CASE("Groups that change while they sound make no broadband sound above -80 dB") {
    const double budget = GENERATE(1e6, 25.0); // all modes, and fewer than there are groups
    const double contactSeconds = GENERATE(0.0, 0.025);
    const ModalObject object = denseObject();
    const auto play = [&](double compression) {
        Synthesiser synthesiser({slotOf(object)}, sampleRate);
        std::int32_t fewest = 1000, most = 0;
        auto output = render(synthesiser, {{0, unitStrike(contactSeconds)}}, 120, [&](int cell) {
            SynthesisSettings settings = settingsOf(cell % 14 < 7 ? 2 : 30, compression);
            settings.modeBudget = budget;
            synthesiser.setSettings(settings);
            if (cell > 2) {
                fewest = std::min(fewest, synthesiser.status()[0].modesRinging);
                most = std::max(most, synthesiser.status()[0].modesRinging);
            }
        });
        CHECK(most == 60);
        CHECK((fewest < 40) == (compression > 0));
        return output;
    };
    auto output = play(1);
    auto apart = play(0);
    double peak = 0;
    for (const float sample : apart)
        peak = larger(peak, std::abs(double(sample)));
    // Skip the attack of the strike.
    output.erase(output.begin(), output.begin() + 640);
    apart.erase(apart.begin(), apart.begin() + 640);
    const double peakDb = 20 * std::log10(peak);
    CAPTURE(broadbandDb(apart, sampleRate) - peakDb);
    CHECK(broadbandDb(output, sampleRate) - peakDb < -80);
}

TEST_CASE("Channels that get modes with opposite signs stay opposite through regrouping") {
    ModalObject object = denseObject();
    object.radiation.directions = {{1, 0, 0}, {0, 1, 0}};
    object.radiation.frequencyRatios = {1};
    object.radiation.weights.assign(120, 0.1f);
    std::fill_n(object.radiation.weights.begin(), 60, -0.1f);
    Synthesiser synthesiser({slotOf(object)}, sampleRate, 2);
    double loudest = 0;
    for (int c = 0; c < 60; ++c) {
        std::array<float, cellSamples> left{}, right{};
        const CellOutput cell(left, right);
        SynthesisSettings settings = settingsOf(c % 14 < 7 ? 2 : 30);
        settings.radiation = 1;
        settings.modeBudget = 25;
        synthesiser.setSettings(settings);
        synthesiser.beginCell(cell);
        if (c == 0)
            synthesiser.strike(0, unitStrike(0.025), 3.25, cell);
        for (std::size_t k = 0; k < cellSamples; ++k) {
            REQUIRE(double(left[k]) == -double(right[k]));
            loudest = larger(loudest, std::abs(double(left[k])));
        }
    }
    CHECK(loudest > 0.01);
}
