#include "Synth/ModePoles.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

using namespace idiophone;

namespace {

constexpr double sampleRateHz = 48000;

ModalPole poleAt(double frequencyHz, double damping = 10) {
    return {.stiffness = std::pow(2 * std::numbers::pi * frequencyHz, 2), .damping = damping};
}

ModePoles polesAt(const std::vector<double>& frequenciesHz) {
    ModePoles poles(frequenciesHz.size(), sampleRateHz);
    for (std::size_t g = 0; g < frequenciesHz.size(); ++g)
        poles.set(g, poleAt(frequenciesHz[g]));
    return poles;
}

} // namespace

TEST_CASE("Rotations and tables are powers of the complex exponential of the pole") {
    ModePoles poles = polesAt({440});
    poles.update({20, 20000}, {});
    poles.prepare(0);
    const ModalPole pole = poleAt(440);
    const std::complex<double> root{-pole.damping / 2, dampedFrequency(pole)};
    const auto power = [&](double samples) { return std::exp(root * (samples / sampleRateHz)); };
    const PoleArrays& arrays = poles.arrays();
    CHECK(std::abs(std::complex(arrays.cellRe[0], arrays.cellIm[0]) - power(64)) < 1e-12);
    CHECK(
        std::abs(std::complex<double>(double(arrays.subBlockRe[0]), double(arrays.subBlockIm[0])) -
                 power(16)) < 1e-6);
    for (std::size_t k = 0; k < subBlockSamples; ++k) {
        const auto expected = power(static_cast<double>(k));
        CHECK(std::abs(double(arrays.tables[k]) - expected.real()) < 1e-6);
        CHECK(std::abs(double(arrays.tables[subBlockSamples + k]) + expected.imag()) < 1e-6);
    }
}

TEST_CASE("Modes outside the band or silenced are inaudible, and silenced ones resonate") {
    ModePoles poles = polesAt({20, 900, 700, 19999, 20001});
    poles.set(0, poleAt(19.9));
    const std::vector<std::uint8_t> silenced{0, 0, 1, 0, 0};
    poles.update({20, 20000}, silenced);
    const std::vector<bool> audible{false, true, false, true, false};
    for (std::size_t g = 0; g < poles.paddedSize(); ++g) {
        const bool expected = g < audible.size() && audible[g];
        CHECK(poles.audibleWeights()[g] == (expected ? 1.0f : 0.0f));
    }
    CHECK(poles.audibleCount() == 2);
    REQUIRE(poles.resonances().size() == 3);
    CHECK(std::abs(poles.resonances()[0] - 900) < 1e-3);
    CHECK(std::abs(poles.resonances()[1] - 700) < 1e-3);
    CHECK(std::abs(poles.resonances()[2] - 19999) < 1e-3);
}

TEST_CASE("Modes near or beyond critical damping are heavy and do not rotate") {
    ModePoles poles = polesAt({440, 440});
    poles.set(1, poleAt(440, 4 * std::numbers::pi * 440));
    poles.update({20, 20000}, {});
    poles.prepare(0);
    const auto heavy = poles.heavy().in(0, poles.paddedSize());
    REQUIRE(heavy.size() == 1);
    CHECK(heavy[0].mode == 1);
    CHECK(poles.arrays().cellRe[1] == 0.0);
    CHECK(poles.arrays().subBlockIm[1] == 0.0f);
    CHECK(poles.audibleWeights()[1] == 1.0f);
    CHECK(poles.resonances().size() == 1);
}

TEST_CASE("A new mode has the pole of the first mode that it takes from") {
    ModePoles poles = polesAt({300, 400, 500, 600});
    poles.update({20, 20000}, {});
    const std::vector<ModeShare> shares{{0, 0, 1}, {1, 0, 1}, {2, 1, 0.5}, {2, 2, 0.5}, {3, 2, 1}};
    poles.regroup(3, shares);
    REQUIRE(poles.size() == 3);
    CHECK(poles.pole(0) == poleAt(300));
    CHECK(poles.pole(1) == poleAt(500));
    CHECK(poles.pole(2) == poleAt(500));
    CHECK(poles.audibleCount() == 0);
    CHECK(poles.resonances().empty());
    poles.update({20, 20000}, {});
    CHECK(poles.audibleCount() == 3);
}
