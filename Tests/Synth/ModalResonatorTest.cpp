// Tests which modes ring, which are mixed, and how they come and go.
#include "Synth/ModalResonator.h"
#include "ModalReference.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRate = 44100;

} // namespace

TEST_CASE("A mode is dropped within a cell of eq. 14's t_c") {
    const double tau = GENERATE(0.01, 2.0, 300.0);
    const double extraDamping = GENERATE(0.0, 15.0);
    const ModalObject object = ringingObject({440}, 40);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    SynthesisSettings settings = exactSettings();
    settings.tau = tau;
    synthesiser.setSettings(settings);
    synthesiser.setDamping(0, extraDamping);
    int dropped = -1;
    render(synthesiser, {{0, unitStrike()}}, 2000, [&](int cell) {
        if (cell > 2 && dropped < 0 && synthesiser.status()[0].modesRinging == 0)
            dropped = cell - 1;
    });
    // 2|c||ω⁺| for a unit impulse from rest: c = 1/(2iω_d).
    const double natural = 2 * std::numbers::pi * 440;
    const double damped = std::sqrt(natural * natural - 20 * 20);
    const double end = std::log(natural / damped / (tau * pascalsPerTau)) / (20 + extraDamping);
    CHECK(std::abs(dropped - end * sampleRate / cellSamples) <= 1);
}

TEST_CASE("An over-damped mode is dropped once its bound falls below tau") {
    ModalObject object = ringingObject({100}, 10000);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    SynthesisSettings settings = exactSettings();
    settings.tau = 0.05;
    synthesiser.setSettings(settings);
    int dropped = -1;
    const auto output = render(synthesiser, {{0, unitStrike()}}, 800, [&](int cell) {
        if (cell > 2 && dropped < 0 && synthesiser.status()[0].modesRinging == 0)
            dropped = cell - 1;
    });
    const double lambda = std::pow(2 * std::numbers::pi * 100, 2);
    const double gap = std::sqrt(1e8 - 4 * lambda);
    const double slow = (10000 - gap) / 2;
    // At the grid point after the impact the fast half has decayed; |c⁺ω⁺| with the slow root
    // remains.
    const double end = std::log(slow / gap / (0.05 * pascalsPerTau)) / slow;
    CHECK(std::abs(dropped - end * sampleRate / cellSamples) <= 1);
}

TEST_CASE("Lowering tau restores a mode at its current state") {
    const ModalObject object = ringingObject({440, 700}, 20);
    const ReferenceMode low = referenceMode(object.material, 440, 1);
    const ReferenceMode high = referenceMode(object.material, 700, 1);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    SynthesisSettings settings = exactSettings();
    synthesiser.setSettings(settings);
    const auto output = render(synthesiser, {{0, unitStrike()}}, 500, [&](int cell) {
        settings.tau = cell >= 100 && cell < 300 ? 65536 : 0;
        synthesiser.setSettings(settings);
        synthesiser.setDamping(0, cell >= 150 && cell < 200 ? 30 : 0);
        if (cell == 200)
            CHECK(synthesiser.silent());
    });
    for (std::size_t k = 110 * 64; k < 300 * 64; ++k)
        REQUIRE(output[k] == 0.0f);
    const double damped = std::exp(-30 * 50 * 64 / sampleRate);
    double error = 0;
    for (std::size_t k = 305 * 64; k < output.size(); ++k) {
        const double t = double(k) / sampleRate;
        const double expected = damped * (impulseVelocity(low, t) + impulseVelocity(high, t));
        error = larger(error, std::abs(double(output[k]) - expected));
    }
    CHECK(error < 1e-8);
    CHECK(synthesiser.status()[0].modesMixed == 2);
}

TEST_CASE("After a reset no change of settings restores the old sound, and strikes sound as new") {
    const ModalObject object = ringingObject({440, 700}, 5);
    Synthesiser used({slotOf(object)}, sampleRate), fresh({slotOf(object)}, sampleRate);
    SynthesisSettings settings = exactSettings();
    settings.tau = 1;
    used.setSettings(settings);
    render(used, {{0, unitStrike()}}, 5);
    used.reset();
    settings.tau = 0;
    settings.sizeRatio = 1.5;
    for (auto* synthesiser : {&used, &fresh}) {
        synthesiser->setSettings(settings);
        synthesiser->setDamping(0, 2);
    }
    CHECK(render(used, {}, 5) == render(fresh, {}, 5));
    CHECK(used.silent());
    SoundingGroups groups(2);
    used.report(0, groups);
    CHECK(groups.count == 2);
    CHECK(std::ranges::all_of(groups.amplitudes, [](float amplitude) { return amplitude == 0; }));
    const auto again = render(used, {{0, unitStrike(2e-3)}}, 50);
    CHECK(again == render(fresh, {{0, unitStrike(2e-3)}}, 50));
    CHECK(std::ranges::any_of(again, [](float sample) { return sample != 0; }));
}

TEST_CASE("Modes that the budget drops and restores make no broadband sound above -80 dB") {
    const ModalObject object = ringingObject({200, 300, 410}, 0.1, {1.0f, 0.9f, 0.8f});
    const auto play = [&](int smallest) {
        Synthesiser synthesiser({slotOf(object)}, sampleRate);
        SynthesisSettings settings = exactSettings();
        synthesiser.setSettings(settings);
        auto output = render(synthesiser, {{0, unitStrike()}}, 160, [&](int cell) {
            settings.modeBudget = cell % 40 < 20 ? 3 : smallest;
            synthesiser.setSettings(settings);
        });
        CHECK(synthesiser.status()[0].modesMixed == smallest);
        // Skip the attack of the strike.
        return std::vector<float>(output.begin() + 640, output.end());
    };
    CHECK(broadbandDb(play(1), sampleRate) < -80);
    CHECK(broadbandDb(play(0), sampleRate) < -80);
    // As a control, the measure detects a step when the same mode is cut at once.
    auto cut = play(3);
    std::fill(cut.begin() + 1700, cut.end(), 0.0f);
    CHECK(broadbandDb(cut, sampleRate) > -60);
}

TEST_CASE("Raising and lowering tau makes no broadband sound above -80 dB") {
    const ModalObject object = ringingObject({200, 300}, 0.1);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    SynthesisSettings settings = exactSettings();
    const auto output = render(synthesiser, {{0, unitStrike()}}, 120, [&](int cell) {
        settings.tau = cell % 40 < 20 ? 0 : 1e6;
        synthesiser.setSettings(settings);
    });
    CHECK(broadbandDb(std::span(output).subspan(640), sampleRate) < -80);
}

TEST_CASE("A strike during fades of modes sounds exact once the fades have ended") {
    const ModalObject object = ringingObject({200, 300, 410}, 3, {1.0f, 0.9f, 0.8f});
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    SynthesisSettings settings = exactSettings();
    const auto output = render(synthesiser, {{0, unitStrike()}, {20 * 64 + 40.5, unitStrike(2e-3)}},
                               60, [&](int cell) {
                                   settings.modeBudget = cell < 19 || cell > 20 ? 3 : 1;
                                   synthesiser.setSettings(settings);
                               });
    double error = 0;
    for (std::size_t k = 32 * 64; k < output.size(); ++k) {
        double expected = 0;
        const std::array frequencies{200.0, 300.0, 410.0};
        const std::array residues{1.0, 0.81, 0.64};
        for (std::size_t i = 0; i < 3; ++i) {
            const ReferenceMode mode = referenceMode(object.material, frequencies[i], residues[i]);
            expected += impulseVelocity(mode, double(k) / sampleRate) +
                        pulseVelocity(mode, 2e-3, (double(k) - 1320.5) / sampleRate);
        }
        error = larger(error, std::abs(double(output[k]) - expected));
    }
    CHECK(error < 1e-5);
}

TEST_CASE("Modes outside 20 Hz to 0.49 of the sample rate are silent and return when in band") {
    const ModalObject object = ringingObject({15, 440, 21700}, 1);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(exactSettings());
    std::vector<std::int32_t> mixed;
    const auto output = render(synthesiser, {{0, unitStrike()}}, 60, [&](int cell) {
        mixed.push_back(synthesiser.status()[0].modesMixed);
        if (cell == 10)
            synthesiser.setFrequencyRatio(0, 0.9);
        if (cell == 20)
            synthesiser.setFrequencyRatio(0, 1.4);
    });
    CHECK(mixed[9] == 1);
    CHECK(mixed[15] == 2);
    CHECK(mixed[25] == 2); // 21 Hz and 616 Hz; the mode at 30 kHz is out of band again
    const ReferenceMode heard = referenceMode(object.material, 440, 1);
    CHECK(errorDb({output.begin(), output.begin() + 640}, [&](double sample) {
              return impulseVelocity(heard, sample / sampleRate);
          }) < -110);
}

TEST_CASE("A small share mixes the strongest modes, and all objects together mix at most Q") {
    std::vector<double> frequencies;
    std::vector<float> gains;
    for (int k = 0; k < 20; ++k) {
        frequencies.push_back(300 + 333 * k);
        gains.push_back(0.2f + 0.1f * static_cast<float>((k * 7) % 20));
    }
    const ModalObject object = ringingObject(frequencies, 1, gains);
    Synthesiser synthesiser({slotOf(object), slotOf(object), slotOf(object)}, sampleRate);
    SynthesisSettings settings = exactSettings();
    settings.modeBudget = 30;
    settings.qualitySlope = 1;
    synthesiser.setSettings(settings);
    Strike loud = unitStrike();
    loud.impulseNewtonSeconds = {0, 0, -3};
    Strike soft = unitStrike();
    soft.impulseNewtonSeconds = {0, 0, -0.2f};
    render(synthesiser, {{0, unitStrike(), 1}, {1, loud, 2}, {2, soft, 0}}, 20);
    // By rank 40/3, 10 and 20/3, rounded down; the remaining one goes to the loudest.
    CHECK(synthesiser.status()[2].modesMixed == 14);
    CHECK(synthesiser.status()[1].modesMixed == 10);
    CHECK(synthesiser.status()[0].modesMixed == 6);
    CHECK(synthesiser.modesMixed() == 30);
    CHECK(synthesiser.status()[0].modesRinging == 20);

    // The sound of slot 2 is that of its 14 strongest modes (residues gain²).
    Synthesiser alone({slotOf(object)}, sampleRate);
    settings.modeBudget = 14;
    alone.setSettings(settings);
    const auto output = render(alone, {{0, unitStrike()}}, 20);
    std::vector<std::size_t> order(20);
    for (std::size_t k = 0; k < 20; ++k)
        order[k] = k;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return gains[a] > gains[b]; });
    CHECK(errorDb(output, [&](double sample) {
              double sum = 0;
              for (std::size_t k = 0; k < 14; ++k) {
                  const double gain = gains[order[k]];
                  sum += impulseVelocity(
                      referenceMode(object.material, frequencies[order[k]], gain * gain),
                      sample / sampleRate);
              }
              return sum;
          }) < -110);
}

TEST_CASE("The sound reaches silence with exact zeros and no denormals, even with tau 0") {
    const double tau = GENERATE(0.0, 0.01);
    const double contactSeconds = GENERATE(0.0, 3e-3);
    Synthesiser synthesiser({slotOf(ringingObject({50, 440, 9000}, 100))}, sampleRate);
    SynthesisSettings settings = exactSettings();
    settings.tau = tau;
    synthesiser.setSettings(settings);
    const auto output = render(synthesiser, {{5, unitStrike(contactSeconds)}}, 1200);
    for (const float sample : output)
        REQUIRE(std::fpclassify(sample) != FP_SUBNORMAL);
    CHECK(synthesiser.silent());
    CHECK(output.back() == 0.0f);
    CHECK(synthesiser.modesMixed() == 0);
}

TEST_CASE("A contact keeps its modes while it lasts, whatever tau and the budget become") {
    const ModalObject object = ringingObject({440, 700}, 20);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    SynthesisSettings settings = exactSettings();
    std::vector<std::int32_t> mixed;
    const double contactSeconds = 5e-3; // from sample 10 to 230.5, in cell 3
    const auto output = render(synthesiser, {{10, unitStrike(contactSeconds)}}, 8, [&](int cell) {
        settings.modeBudget = cell == 0 ? 10 : 1;
        settings.tau = cell == 0 ? 0 : 65536;
        synthesiser.setSettings(settings);
        mixed.push_back(synthesiser.status()[0].modesMixed);
    });
    CHECK(mixed[4] == 2); // of cell 3
    CHECK(mixed[5] == 0);
    double error = 0;
    for (std::size_t k = 0; k < 256; ++k) {
        double expected = 0;
        for (const double hz : {440.0, 700.0})
            expected += pulseVelocity(referenceMode(object.material, hz, 1), contactSeconds,
                                      (double(k) - 10) / sampleRate);
        error = larger(error, std::abs(double(output[k]) - expected));
    }
    CHECK(error < 1e-6);
}

TEST_CASE("A mode bent out of the band and back returns even if nothing else rings") {
    const ModalObject object = ringingObject({20000}, 5);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(exactSettings());
    const auto output = render(synthesiser, {{0, unitStrike()}}, 60, [&](int cell) {
        if (cell == 10 || cell == 30)
            synthesiser.setFrequencyRatio(0, cell == 10 ? 1.2 : 1);
        if (cell == 25)
            CHECK(synthesiser.silent());
    });
    const double expected = std::exp(-2.5 * 50 * 64 / sampleRate);
    double peak = 0;
    for (std::size_t k = 50 * 64; k < 51 * 64; ++k)
        peak = larger(peak, std::abs(double(output[k])));
    CHECK(std::abs(peak - expected) < 0.02);
}
