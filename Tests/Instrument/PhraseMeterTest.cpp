#include "Instrument/PhraseMeter.h"
#include "IntegratedLufs.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRateHz = 48000;

/// The meter's phrase of one mode of that amplitude, as samples through libebur128.
double
measuredLufs(const PhraseMeter::NoteFigures& amplitudes, double hz, double decay, double release) {
    std::vector<double> sound(static_cast<std::size_t>(4.5 * sampleRateHz));
    for (std::size_t note = 0; note < PhraseMeter::notes; ++note) {
        const auto start = note * 24000;
        for (std::size_t k = start; k < sound.size(); ++k) {
            const double seconds = static_cast<double>(k - start) / sampleRateHz;
            const double fallen = decay * seconds + release * std::max(seconds - 0.5, 0.0);
            // Notes in quadrature to their neighbours add in energy.
            sound[k] +=
                amplitudes[note] * std::exp(-fallen) *
                std::sin(std::numbers::pi * (2 * hz * seconds + static_cast<double>(note) / 2));
        }
    }
    return integratedLufs(std::vector<float>(sound.begin(), sound.end()), 1, sampleRateHz);
}

} // namespace

TEST_CASE("K-weighting is the standard's: +0.691 dB at 997 Hz, +4 dB at the top") {
    const auto decibels = [](double hz) { return 10 * std::log10(kWeightingPower(hz)); };
    CHECK(std::abs(decibels(997) - 0.691) < 0.01);
    CHECK(std::abs(decibels(15000) - 4) < 0.05);
    CHECK(decibels(20) < -12);
    CHECK(kWeightingPower(0) == 0);
}

TEST_CASE("A phrase of decaying notes measures as libebur128 measures its samples, within 0.2 LU") {
    const PhraseMeter::NoteFigures even{0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1};
    const PhraseMeter::NoteFigures gated{0.1, 0.02, 0.01, 0.01, 0.1, 0.001, 0.002, 0.05};
    for (const auto& amplitudes : {even, gated})
        for (const double hz : {80.0, 440.0, 5000.0})
            for (const double decay : {6.0, 30.0, 300.0})
                for (const double release : {0.0, 40.0}) {
                    if (decay > 0.2 * 2 * std::numbers::pi * hz)
                        continue; // no frequency by which to weigh it
                    PhraseMeter::NoteFigures powers{};
                    for (std::size_t note = 0; note < powers.size(); ++note)
                        powers[note] =
                            kWeightingPower(hz) * amplitudes[note] * amplitudes[note] / 2;
                    PhraseMeter meter;
                    meter.addMode(PhraseMeter::Note::struck, powers, decay, release);
                    const double measured = measuredLufs(amplitudes, hz, decay, release);
                    INFO(hz << " Hz, decay " << decay << ", release " << release << ": " << measured
                            << " LUFS");
                    CHECK(std::abs(meter.integratedLufs() - measured) < 0.2);
                }
}

TEST_CASE("A sustained note carries the energy of a struck one") {
    const PhraseMeter::NoteFigures powers{1, 1, 1, 1, 1, 1, 1, 1};
    PhraseMeter struck, sustained;
    struck.addMode(PhraseMeter::Note::struck, powers, 20, 0);
    sustained.addMode(PhraseMeter::Note::sustained, powers, 20, 0);
    CHECK(std::abs(struck.integratedLufs() - sustained.integratedLufs()) < 1.5);
}

TEST_CASE("A steady power is heard as long as the notes: −0.691 LUFS for 1") {
    PhraseMeter meter;
    meter.addSteady({1, 1, 1, 1, 1, 1, 1, 1});
    CHECK(std::abs(meter.integratedLufs() - -0.691) < 0.3);
}

TEST_CASE("Silence measures −infinity") {
    CHECK(std::isinf(PhraseMeter().integratedLufs()));
}
