#include "Instrument/PhraseMeter.h"
#include "IntegratedLufs.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRateHz = 48000;

using Note = PhraseMeter::Note;

/// Returns a mode's envelope at a time after its note began. An energy of 1 arrives at once or
/// throughout the note; after the note `release` adds to the decay.
double envelope(Note kind, double seconds, double decay, double release) {
    constexpr double held = PhraseMeter::noteSeconds;
    const double after = std::max(seconds - held, 0.0);
    const double struck = std::exp(-2 * decay * seconds);
    const double sustained = (std::exp(-2 * decay * after) - struck) / (2 * decay * held);
    return std::sqrt(kind == Note::struck ? struck : sustained) * std::exp(-release * after);
}

/// Returns libebur128's loudness of the meter's phrase, played by one mode of these amplitudes.
double measuredLufs(Note kind,
                    const PhraseMeter::NoteFigures& amplitudes,
                    double hz,
                    double decay,
                    double release) {
    std::vector<double> sound(static_cast<std::size_t>(4.5 * sampleRateHz));
    for (std::size_t note = 0; note < PhraseMeter::notes; ++note) {
        const auto start = note * 24000;
        for (std::size_t k = start; k < sound.size(); ++k) {
            const double seconds = static_cast<double>(k - start) / sampleRateHz;
            // Neighbouring notes are in quadrature, so their energies add.
            sound[k] +=
                amplitudes[note] * envelope(kind, seconds, decay, release) *
                std::sin(std::numbers::pi * (2 * hz * seconds + static_cast<double>(note) / 2));
        }
    }
    return integratedLufs(std::vector<float>(sound.begin(), sound.end()), 1, sampleRateHz);
}

/// Returns the meter's error in LU.
double errorOf(Note kind,
               const PhraseMeter::NoteFigures& amplitudes,
               double hz,
               double decay,
               double release) {
    PhraseMeter::NoteFigures powers{};
    for (std::size_t note = 0; note < powers.size(); ++note)
        powers[note] = kWeightingPower(hz) * amplitudes[note] * amplitudes[note] / 2;
    PhraseMeter meter;
    meter.addMode(kind, powers, decay, release);
    return meter.integratedLufs() - measuredLufs(kind, amplitudes, hz, decay, release);
}

constexpr PhraseMeter::NoteFigures even{0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1};
constexpr PhraseMeter::NoteFigures gated{0.1, 0.02, 0.01, 0.01, 0.1, 0.001, 0.002, 0.05};

} // namespace

TEST_CASE("K-weighting is the standard's: +0.691 dB at 997 Hz, +4 dB at the top") {
    const auto decibels = [](double hz) { return 10 * std::log10(kWeightingPower(hz)); };
    CHECK(std::abs(decibels(997) - 0.691) < 0.01);
    CHECK(std::abs(decibels(15000) - 4) < 0.05);
    CHECK(decibels(20) < -12);
    CHECK(kWeightingPower(0) == 0);
}

TEST_CASE("A phrase of decaying notes measures as libebur128 measures its samples, within 0.2 LU") {
    for (const auto& amplitudes : {even, gated})
        for (const double hz : {80.0, 440.0, 5000.0})
            for (const double decay : {6.0, 30.0, 300.0})
                for (const double release : {0.0, 40.0}) {
                    if (decay > 0.2 * 2 * std::numbers::pi * hz)
                        continue; // too damped to have a frequency
                    INFO(hz << " Hz, decay " << decay << ", release " << release);
                    CHECK(std::abs(errorOf(Note::struck, amplitudes, hz, decay, release)) < 0.2);
                }
}

TEST_CASE(
    "A phrase of sustained notes measures as libebur128 measures its samples, within 0.2 LU") {
    for (const auto& amplitudes : {even, gated})
        for (const double decay : {0.01, 2.0, 30.0}) {
            INFO("decay " << decay);
            CHECK(std::abs(errorOf(Note::sustained, amplitudes, 440, decay, 40)) < 0.2);
        }
}

TEST_CASE("A steady power of 1 during the notes measures -0.691 LUFS") {
    PhraseMeter meter;
    meter.addSteady({1, 1, 1, 1, 1, 1, 1, 1});
    CHECK(std::abs(meter.integratedLufs() - -0.691) < 0.3);
}

TEST_CASE("Silence measures -infinity") {
    CHECK(std::isinf(PhraseMeter().integratedLufs()));
}
