// SPDX-License-Identifier: Apache-2.0
#include "Synth/SurfaceProfile.h"

#include "Synth/ComplexProduct.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace idiophone {
namespace {

using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;

/// Steele, Lea & Flood 2014: the same numbers on every platform, unlike std distributions.
class SplitMix64 {
public:
    explicit SplitMix64(std::uint64_t seed) : state(seed) {}

    /// Returns −1 ≤ x < 1.
    double signedUniform() {
        std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
        z = (z ^ z >> 27) * 0x94d049bb133111ebu;
        return static_cast<double>((z ^ z >> 31) >> 11) * 0x1p-52 - 1;
    }

    /// Returns a uniform point of the unit circle.
    Complex phase() {
        for (;;) {
            // Compilers evaluate arguments in different orders.
            const double imaginary = signedUniform();
            const Complex point(signedUniform(), imaginary);
            const double square = std::norm(point);
            if (square > 0.01 && square <= 1)
                return point / std::sqrt(square);
        }
    }

private:
    std::uint64_t state;
};

/// Computes Σ_k X_k e^{2πi kn/N} in place; N is a power of two. Radix 2, decimation in time.
void inverseTransform(std::vector<Complex>& values) {
    const std::size_t size = values.size();
    for (std::size_t i = 1, reversed = 0; i < size; ++i) {
        std::size_t bit = size >> 1;
        for (; (reversed & bit) != 0; bit >>= 1)
            reversed ^= bit;
        reversed ^= bit;
        if (i < reversed)
            std::swap(values[i], values[reversed]);
    }
    std::vector<Complex> roots(size / 2);
    for (std::size_t i = 0; i < roots.size(); ++i)
        roots[i] = std::polar(1.0, 2 * pi * static_cast<double>(i) / static_cast<double>(size));
    for (std::size_t half = 1; half < size; half *= 2)
        for (std::size_t start = 0; start < size; start += 2 * half)
            for (std::size_t i = 0; i < half; ++i) {
                auto &upper = values[start + i], &lower = values[start + half + i];
                const Complex turned = product(lower, roots[i * (size / 2 / half)]);
                lower = upper - turned;
                upper += turned;
            }
}

constexpr std::size_t highestHarmonic = SurfaceProfile::periodSamples / 2 - 1;

/// Returns the power of a harmonic relative to the lowest.
double harmonicPower(std::size_t harmonic, double exponent) {
    return std::pow(static_cast<double>(harmonic) / SurfaceProfile::lowestHarmonic, exponent);
}

/// Every harmonic has its exact magnitude and a random phase.
std::vector<float> profileTable(double exponent, std::uint64_t seed) {
    SplitMix64 random(seed);
    std::vector<Complex> values(SurfaceProfile::periodSamples * SurfaceProfile::oversampling);
    double power = 0;
    for (std::size_t k = SurfaceProfile::lowestHarmonic; k <= highestHarmonic; ++k) {
        const double harmonic = harmonicPower(k, exponent);
        values[k] = random.phase() * std::sqrt(harmonic);
        power += harmonic / 2;
    }
    inverseTransform(values);
    const double scale = 1 / std::sqrt(power);
    std::vector<float> table(values.size() + 1);
    for (std::size_t i = 0; i < values.size(); ++i)
        table[i] = static_cast<float>(values[i].real() * scale);
    table.back() = table.front();
    return table;
}

} // namespace

SurfaceProfile::SurfaceProfile(Surface surface, double sampleRateHz, std::uint64_t seed)
    : playedSurface(std::move(surface)), rateHz(sampleRateHz),
      table(profileTable(playedSurface.spectrumExponent, seed)) {
    for (std::size_t i = 1; i < gainCount; ++i)
        gains[i] = 1 / scrapeRms(static_cast<double>(i) / (gainCount - 1));
    gains[0] = gains[1];
}

ResonPole SurfaceProfile::resonPole(double speedRatio) const noexcept {
    // At rest the pole would be 1 and its gain infinite.
    const double ratio = std::clamp(speedRatio, 1e-4, 1.0);
    return ResonPole::at(playedSurface.resonFrequencyHz * ratio,
                         playedSurface.resonDampingPerSecond * ratio, rateHz);
}

double SurfaceProfile::gain(double speedRatio) const noexcept {
    const double place = std::clamp(speedRatio, 0.0, 1.0) * (gainCount - 1);
    const auto index = std::min(static_cast<std::size_t>(place), gainCount - 2);
    return gains[index] + (place - static_cast<double>(index)) * (gains[index + 1] - gains[index]);
}

/// In continuous time the rms would be the same at all speeds, because the sound is only stretched.
double SurfaceProfile::scrapeRms(double speedRatio) const {
    const ResonPole pole = resonPole(speedRatio);
    const double inputGain = pole.unitGainAtZero();
    double before = 0, after = 0;
    for (std::size_t k = lowestHarmonic; k <= highestHarmonic; ++k) {
        const double power = harmonicPower(k, playedSurface.spectrumExponent);
        const double angle = 2 * pi * static_cast<double>(k) / periodSamples * speedRatio;
        before += power;
        after += power * pole.power(std::cos(angle));
    }
    return inputGain * std::sqrt(after / before);
}

} // namespace idiophone
