#include "Instrument/StiffMotion.h"

#include "Support/Periodogram.h"
#include "Synth/SurfaceProfile.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE("Below a mode the power of a roll is that of the sampled response within 0.5 dB") {
    constexpr double rateHz = 48000;
    const double omega = 2 * std::numbers::pi * 3000;
    const HeldForceSpectrum force({}, 0.5, {.kind = ContactKind::roll}, {}, rateHz);
    StiffMotion stiff(rateHz);
    StiffMotion::NoteResidues residues{};
    residues[2] = {1, 1};
    stiff.add(omega, residues);

    // Σ cos(ω_i n/f_s) z^(−n)/f_s at each frequency, with half of its first sample, and its mirror
    // image above. With the whole first sample, a force at rest would be heard.
    double expected = 0;
    const double step = 2 * std::numbers::pi * 0.5;
    for (double at = 2 * std::numbers::pi * 22; at < std::numbers::pi * rateHz; at += step) {
        const double ratio = at / omega;
        if (ratio > 0.632 && ratio < 1.581)
            continue;
        const auto turn = std::polar(1.0, -at / rateHz);
        const double cosine = std::cos(omega / rateHz);
        const auto response =
            ((1.0 - cosine * turn) / (1.0 - 2 * cosine * turn + turn * turn) - 0.5) / rateHz;
        expected += std::norm(response) * force.smoothPower(at) *
                    kWeightingPower(at / (2 * std::numbers::pi)) * step / std::numbers::pi;
    }
    const auto powers = stiff.powers(force);
    CHECK(std::abs(10 * std::log10(powers[2] / expected)) < 0.5);
    CHECK(powers[1] == 0);
}
