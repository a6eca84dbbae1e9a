// Tests continuous force on a resonator.
#include "ModalReference.h"
#include "Synth/ForceKernel.h"
#include "Synth/ModalPole.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <random>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRate = 48000;

/// An object with two vertices of different shapes.
ModalObject twoPlaces(const std::vector<double>& frequencies) {
    ModalObject object = syntheticObject(frequencies);
    const std::size_t modes = frequencies.size();
    object.vertices = {0, 0, 0, 0.1f, 0, 0, 0, 0.1f, 0};
    object.faces = {0, 1, 2};
    object.shapeVertices = {0, 1};
    object.shapes.assign(2 * modes * 3, 0);
    for (std::size_t i = 0; i < modes; ++i) {
        object.shapes[3 * i + 2] = 1 + 0.01f * static_cast<float>(i);
        object.shapes[3 * (modes + i) + 2] = 0.4f - 0.02f * static_cast<float>(i);
    }
    return object;
}

StrikePoint vertex(int row) {
    return {.shapeRows = {row}, .weights = {1}, .normal = {0, 0, 1}};
}

ForcePlace place(int row) {
    return {.points = {ForcePoint{.point = vertex(row)}}};
}

struct Scraped {
    std::vector<float> forces;
    std::vector<float> output;
};

/// Applies a random force for `cells` cells, then as many cells of silence. The contact moves from
/// one place to the other and back, or does not move.
Scraped scrape(const ModalObject& object, int cells, bool moving, double damping, double tau) {
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    SynthesisSettings settings = exactSettings();
    settings.tau = tau;
    synthesiser.setSettings(settings);
    synthesiser.setDamping(0, damping);
    std::mt19937 random(3);
    Scraped result;
    for (int c = 0; c < 2 * cells; ++c) {
        std::array<float, cellSamples> cell{};
        std::array<float, cellSamples> newtons{};
        synthesiser.beginCell(cell);
        if (c < cells) {
            for (float& newton : newtons)
                newton = static_cast<float>(random()) / 2147483648.0f - 1;
            const int from = moving ? c % 2 : 0;
            const int to = moving ? (c + 1) % 2 : 0;
            REQUIRE(synthesiser.applyForce(
                0, {.start = place(from), .end = place(to), .newtons = newtons}, cell));
        }
        result.forces.insert(result.forces.end(), newtons.begin(), newtons.end());
        result.output.insert(result.output.end(), cell.begin(), cell.end());
    }
    return result;
}

/// Computes the force's sound in double precision: an impulse at each sample, residues in steps of
/// a sub-block. Half of an impulse sounds at its own sample, and a constant force is silent.
std::vector<double>
reference(const ModalObject& object, const Scraped& scraped, bool moving, double damping) {
    const std::size_t modes = object.modeCount();
    std::vector<double> output(scraped.output.size());
    for (std::size_t i = 0; i < modes; ++i) {
        const ModalPole pole = PoleLaw{1, object.material.damping}.pole(object.eigenvalues[i]);
        const Propagator sample = propagator(pole, 1 / sampleRate);
        const double fall = std::exp(-damping / sampleRate);
        const auto residueAt = [&](std::size_t row) {
            const auto shape = static_cast<double>(object.shapesAt(row)[3 * i + 2]);
            return shape * shape;
        };
        // The sum of half the first and all later samples after an impulse, without a damper.
        ModalState ringing = stateOf(pole, {1, 0});
        double rest = ringing.x / 2;
        for (int k = 0; k < 4000000 && std::abs(ringing.x) + std::abs(ringing.y) > 1e-13; ++k)
            rest -= (ringing = sample * ringing).x;
        rest = isOscillating(pole) ? rest - 1 : 0.5; // heavy modes keep the whole first sample
        ModalState state;
        for (std::size_t n = 0; n < output.size(); ++n) {
            const std::size_t cell = n / cellSamples;
            const double share =
                moving ? static_cast<double>(fractionAt(n % cellSamples / subBlockSamples)) : 0;
            const double residue = residueAt(moving ? cell % 2 : 0) * (1 - share) +
                                   residueAt(moving ? (cell + 1) % 2 : 0) * share;
            const ModalState increment =
                stateOf(pole, {residue * static_cast<double>(scraped.forces[n]) / sampleRate, 0});
            output[n] += state.x + increment.x / 2 + increment.x * rest;
            state = {state.x + increment.x, state.y + increment.y};
            state = sample * state;
            state = {fall * state.x, fall * state.y};
        }
    }
    return output;
}

double differenceDb(const std::vector<float>& output, const std::vector<double>& expected) {
    double peak = 0, worst = 0;
    for (std::size_t n = 0; n < output.size(); ++n) {
        peak = larger(peak, std::abs(expected[n]));
        worst = larger(worst, std::abs(static_cast<double>(output[n]) - expected[n]));
    }
    return 20 * std::log10(worst / peak);
}

} // namespace

TEST_CASE("A continuous force equals an impulse at every sample within -100 dB") {
    const bool moving = GENERATE(false, true);
    const double damping = GENERATE(0.0, 40.0);
    const double viscoelastic =
        GENERATE(1e-8, 2e-5); // the second value over-damps modes above 16 kHz
    std::vector<double> frequencies;
    for (int i = 0; i < 30; ++i)
        frequencies.push_back(60 + 23.0 * i * i);
    ModalObject object = twoPlaces(frequencies);
    object.material.damping.viscoelasticSeconds = viscoelastic;
    const Scraped scraped = scrape(object, 150, moving, damping, 0);
    CAPTURE(moving, damping, viscoelastic);
    CHECK(differenceDb(scraped.output, reference(object, scraped, moving, damping)) < -100);
}

TEST_CASE("Impulses that become known within a cell sound as strikes do, in parts of any length") {
    const double damping = GENERATE(0.0, 40.0);
    const ModalObject object = twoPlaces({60, 310, 1250, 4100, 9800, 17000});
    const auto start = [&](Synthesiser& synthesiser) {
        SynthesisSettings settings = exactSettings();
        settings.tau = 0;
        synthesiser.setSettings(settings);
        synthesiser.setDamping(0, damping);
    };
    constexpr int cells = 100;
    std::mt19937 random(5);
    std::vector<float> newtons(cells * cellSamples);
    for (std::size_t n = 0; n < newtons.size() / 2; n += 1 + random() % 40)
        newtons[n] = static_cast<float>(random()) / 2147483648.0f - 1;

    const auto pressed = [&](std::size_t part) {
        Synthesiser synthesiser({slotOf(object)}, sampleRate);
        start(synthesiser);
        std::vector<float> output;
        for (std::size_t c = 0; c < cells; ++c) {
            std::array<float, cellSamples> cell{}, known{};
            synthesiser.beginCell(cell);
            const ForceCell force{
                .start = place(0), .end = place(0), .newtons = known, .isImpulses = true};
            HeardForce heard;
            REQUIRE(synthesiser.beginForce(0, force, heard));
            for (std::size_t from = 0; from < cellSamples; from += part) {
                const std::size_t count = std::min(part, cellSamples - from);
                std::copy_n(newtons.begin() + static_cast<int>(c * cellSamples + from), count,
                            known.begin() + from);
                synthesiser.hearForce(0, heard, force, from, count, cell);
            }
            synthesiser.endForce(0, force);
            output.insert(output.end(), cell.begin(), cell.end());
        }
        return output;
    };
    Synthesiser struck({slotOf(object)}, sampleRate);
    start(struck);
    std::vector<double> expected;
    std::array<float, cellSamples> cell{};
    for (std::size_t n = 0; n < newtons.size(); ++n) {
        if (n % cellSamples == 0)
            struck.beginCell(cell);
        if (newtons[n] != 0.0f)
            REQUIRE(struck.strike(
                0,
                {.point = vertex(0),
                 .impulseNewtonSeconds = {0, 0, -newtons[n] / static_cast<float>(sampleRate)}},
                static_cast<double>(n % cellSamples), cell));
        if (n % cellSamples == cellSamples - 1)
            expected.insert(expected.end(), cell.begin(), cell.end());
    }
    const auto whole = pressed(cellSamples);
    CHECK(differenceDb(whole, expected) < -100);
    for (const std::size_t part : {1, 7, 16, 63})
        CHECK(pressed(part) == whole);
}

TEST_CASE("Modes are kept during a force and dropped once it ends") {
    const ModalObject object = twoPlaces({300, 700, 1500});
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    SynthesisSettings settings = exactSettings();
    settings.tau = 500;
    synthesiser.setSettings(settings);
    std::array<float, cellSamples> newtons;
    newtons.fill(1e-4f);
    std::array<float, cellSamples> cell{};
    for (int c = 0; c < 20; ++c) {
        synthesiser.beginCell(cell);
        CHECK(synthesiser.applyForce(0, {.start = place(0), .end = place(0), .newtons = newtons},
                                     cell));
        if (c > 0)
            CHECK(synthesiser.status()[0].modesMixed == 3);
    }
    for (int c = 0; c < 2; ++c)
        synthesiser.beginCell(cell);
    CHECK(synthesiser.status()[0].modesMixed == 0);
}

TEST_CASE("A force and strikes on the same object add up") {
    const ModalObject object = twoPlaces({300, 700, 1500, 4100});
    const auto play = [&](bool strikes, bool presses) {
        Synthesiser synthesiser({slotOf(object)}, sampleRate);
        synthesiser.setSettings(exactSettings());
        std::vector<float> output;
        std::mt19937 random(5);
        for (int c = 0; c < 60; ++c) {
            std::array<float, cellSamples> cell{};
            std::array<float, cellSamples> newtons;
            for (float& newton : newtons)
                newton = static_cast<float>(random()) / 2147483648.0f - 1;
            synthesiser.beginCell(cell);
            if (presses)
                synthesiser.applyForce(0, {.start = place(1), .end = place(1), .newtons = newtons},
                                       cell);
            if (strikes && c % 7 == 3) {
                Strike strike{.point = vertex(0),
                              .impulseNewtonSeconds = {0, 0, -1e-3f},
                              .durationSeconds = 0.0011};
                synthesiser.strike(0, strike, 11.25, cell);
            }
            output.insert(output.end(), cell.begin(), cell.end());
        }
        return output;
    };
    const auto both = play(true, true);
    const auto struck = play(true, false);
    const auto pressed = play(false, true);
    double peak = 0, worst = 0;
    for (std::size_t n = 0; n < both.size(); ++n) {
        peak = larger(peak, std::abs(double(both[n])));
        worst = larger(worst, std::abs(double(both[n]) - double(struck[n]) - double(pressed[n])));
    }
    CHECK(worst < 1e-5 * peak);
}

TEST_CASE("An invalid force is refused without effect") {
    const ModalObject object = twoPlaces({300});
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    std::array<float, cellSamples> cell{};
    std::array<float, cellSamples> newtons{};
    synthesiser.beginCell(cell);
    CHECK_FALSE(
        synthesiser.applyForce(1, {.start = place(0), .end = place(0), .newtons = newtons}, cell));
    CHECK_FALSE(
        synthesiser.applyForce(0, {.start = place(0), .end = place(2), .newtons = newtons}, cell));
    for (const float newton : {std::numeric_limits<float>::quiet_NaN(), 1.1e12f, -3e38f}) {
        newtons[7] = newton;
        CHECK_FALSE(synthesiser.applyForce(
            0, {.start = place(0), .end = place(0), .newtons = newtons}, cell));
    }
    CHECK(synthesiser.silent());
}

TEST_CASE("A force with an absurdly large response is silent and other sounds continue") {
    ModalObject object = twoPlaces({300, 800});
    object.shapes[3 * 2 + 2] = 3e20f; // first mode at the second place
    Synthesiser synthesiser({slotOf(object)}, sampleRate), spared({slotOf(object)}, sampleRate);
    std::array<float, cellSamples> newtons{};
    for (int c = 0; c < 200; ++c) {
        std::array<float, cellSamples> cell{}, expected{};
        synthesiser.beginCell(cell);
        spared.beginCell(expected);
        newtons.fill(c < 100 ? 5 : 0);
        for (auto* both : {&synthesiser, &spared})
            both->applyForce(0, {.start = place(0), .end = place(0), .newtons = newtons},
                             both == &spared ? expected : cell);
        synthesiser.applyForce(0, {.start = place(1), .end = place(1), .newtons = newtons}, cell);
        REQUIRE(cell == expected);
    }
    CHECK_FALSE(spared.silent());
}
