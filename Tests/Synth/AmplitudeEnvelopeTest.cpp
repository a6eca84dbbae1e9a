#include "Synth/AmplitudeEnvelope.h"
#include "ResonatorParts.h"

#include <catch2/catch_test_macros.hpp>
#include <numeric>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double periodSeconds =
    AmplitudeEnvelope::periodCells * cellSamples / ResonatorParts::sampleRateHz;

/// 20 modes whose decays rise with the frequency, up to 130 times the slowest.
struct SpreadDecays : ResonatorParts {
    SpreadDecays() : ResonatorParts(makeObject()) { ring(); }

    static ModalObject makeObject() {
        std::vector<double> frequencies(20);
        std::iota(frequencies.begin(), frequencies.end(), 1);
        for (double& hz : frequencies)
            hz *= 500;
        ModalObject object = ringingObject(frequencies, 2);
        object.material.damping.viscoelasticSeconds = 1e-7;
        return object;
    }

    /// Returns the summed amplitude after free motion under a damper.
    double amplitudeAfter(double seconds, double dampingPerSecond) const {
        double sum = 0;
        for (std::size_t g = 0; g < bank.size(); ++g)
            sum += (1.0 + static_cast<double>(g)) *
                   std::exp(-(decayBound(bank.pole(g)) + dampingPerSecond) * seconds);
        return sum;
    }
};

} // namespace

TEST_CASE("An envelope starts at the sum of amplitudes and never falls below it") {
    constexpr double damping = 3;
    SpreadDecays parts;
    AmplitudeEnvelope envelope;
    envelope.updateFalls(parts.bank.poles(), damping);
    envelope.set(parts.bank.poles(), parts.bank.energies(), 20);
    CHECK(envelope.modesRinging() == 20);
    CHECK(std::abs(envelope.amplitude() - parts.amplitudeAfter(0, 0)) < 1e-4);
    for (int period = 1; period < 200; ++period) {
        envelope.fall();
        const double sum = parts.amplitudeAfter(period * periodSeconds, damping);
        REQUIRE(envelope.amplitude() > 0.9999 * sum);
    }
    // One bound for all modes, which falls as the slowest, would be nearly 200 times the sum here.
    const double one = parts.amplitudeAfter(0, 0) *
                       std::exp(-(decayBound(parts.bank.pole(0)) + damping) * 199 * periodSeconds);
    const double sum = parts.amplitudeAfter(199 * periodSeconds, damping);
    CHECK(envelope.amplitude() < 4 * sum);
    CHECK(one > 20 * sum);
}

TEST_CASE("State increments raise an envelope, silenced modes do not") {
    SpreadDecays parts;
    std::vector<std::uint8_t> silenced(20, 0);
    silenced[19] = 1;
    parts.bank.movePoles(parts.groups.eigenvalues(), parts.groups.conditions().law, 20, 23000,
                         parts.groups.dampings(), silenced);
    AmplitudeEnvelope envelope;
    envelope.set(parts.bank.poles(), parts.bank.energies(), 19);
    CHECK(std::abs(envelope.amplitude() - 190) < 1e-3);
    AlignedVector<float> energies(2 * modeBlock);
    energies[0] = 4;
    energies[19] = 9;
    envelope.add(parts.bank.poles(), energies.data());
    CHECK(std::abs(envelope.amplitude() - 192) < 1e-3);
    envelope.clear();
    CHECK(envelope.amplitude() == 0.0);
    CHECK(envelope.modesRinging() == 0);
}

TEST_CASE("The falls of an envelope follow the poles only after they were invalidated") {
    SpreadDecays parts;
    AmplitudeEnvelope envelope;
    const auto fallenUnder = [&](double damping) {
        envelope.updateFalls(parts.bank.poles(), damping);
        envelope.set(parts.bank.poles(), parts.bank.energies(), 20);
        envelope.fall();
        return envelope.amplitude();
    };
    const double before = fallenUnder(0);
    CHECK(fallenUnder(50) == before);
    envelope.invalidateFalls();
    CHECK(std::abs(fallenUnder(50) / before - std::exp(-50 * periodSeconds)) < 1e-5);
}
