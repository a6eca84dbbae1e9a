// Tests contacts under way while poles move, including unheard modes.
#include "ModalReference.h"
#include "Synth/ContactPulse.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRate = 48000;
constexpr double contactSeconds = 4e-3; // three cells
constexpr int moveCell = 2;
constexpr int backCell = 30;

/// A mode of residue 1 that is struck at sample 0. Its frequency is `ratio` times its own from
/// moveCell to backCell. When the pole moves, the complex
/// velocity amplitude stays the same.
class MovedMode {
public:
    MovedMode(double eigenvalue, double damping, double ratio)
        : own{eigenvalue, damping}, moved{eigenvalue * ratio * ratio, damping} {
        add(own, 0, -1);
        pass(own, moveCell * cellSamples);
        add(own, moveCell * cellSamples, 1);
        add(moved, moveCell * cellSamples, -1);
        const double end = contactSeconds * sampleRate;
        pass(moved, end - moveCell * cellSamples);
        add(moved, end, 1);
        pass(moved, backCell * cellSamples - end);
    }

    double velocity(double sample) const {
        return (propagator(own, (sample - backCell * cellSamples) / sampleRate) * state).x;
    }

private:
    void pass(const ModalPole& pole, double samples) {
        state = propagator(pole, samples / sampleRate) * state;
    }
    void add(const ModalPole& pole, double sample, double factor) {
        const double turns = sample / sampleRate / contactSeconds;
        const ModalState forced =
            stateOf(pole, ForcedResponse(pole, contactSeconds, 0)
                              .motion(std::polar(1.0, 2 * std::numbers::pi * turns)));
        state = {state.x + factor * forced.x, state.y + factor * forced.y};
    }

    ModalPole own, moved;
    ModalState state;
};

} // namespace

TEST_CASE("A contact ends correctly for a mode that is out of band at its end") {
    const ModalObject object = ringingObject({300, 20000}, 20);
    const MovedMode low(object.eigenvalues[0], 20, 1.25);
    const MovedMode high(object.eigenvalues[1], 20, 1.25);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(exactSettings());
    const auto output = render(synthesiser, {{0, unitStrike(contactSeconds)}}, 80, [&](int cell) {
        if (cell == moveCell || cell == backCell)
            synthesiser.setFrequencyRatio(0, cell == moveCell ? 1.25 : 1);
    });
    double peak = 0;
    double error = 0;
    for (std::size_t k = 40 * cellSamples; k < output.size(); ++k) {
        const double expected = high.velocity(double(k));
        peak = larger(peak, std::abs(expected));
        error = larger(error, std::abs(double(output[k]) - low.velocity(double(k)) - expected));
    }
    CHECK(peak > 1e-4);
    CHECK(error < 0.01 * peak);
}

TEST_CASE("A contact ends correctly for modes too faint to sound and for blocks at rest") {
    // One mode sounds and 31 do not: 15 in its block, 16 in a block at rest.
    std::vector<double> frequencies{200};
    std::vector<float> gains{1};
    for (int k = 1; k < 32; ++k) {
        frequencies.push_back(1000 + 37 * k);
        gains.push_back(0.1f);
    }
    const ModalObject object = ringingObject(frequencies, 20, gains);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    SynthesisSettings settings = exactSettings();
    settings.tau = 0.1 / pascalsPerTau;
    const auto output = render(synthesiser, {{0, unitStrike(contactSeconds)}}, 80, [&](int cell) {
        settings.frequencyRatio = cell >= moveCell && cell < backCell ? 1.25 : 1;
        if (cell == 20)
            CHECK(synthesiser.status()[0].modesRinging == 1);
        if (cell == backCell)
            settings.tau = 0;
        synthesiser.setSettings(settings);
    });
    std::vector<MovedMode> modes;
    for (const double eigenvalue : object.eigenvalues)
        modes.emplace_back(eigenvalue, 20, 1.25);
    double peak = 0;
    double error = 0;
    for (std::size_t k = 40 * cellSamples; k < output.size(); ++k) {
        double faint = 0;
        for (std::size_t i = 1; i < modes.size(); ++i)
            faint += 1e-2 * modes[i].velocity(double(k));
        peak = larger(peak, std::abs(faint));
        error = larger(error, std::abs(double(output[k]) - faint - modes[0].velocity(double(k))));
    }
    CHECK(peak > 1e-4);
    CHECK(error < 0.01 * peak);
}
