// Reference modal synthesis by equations 6 to 11 of Raghuvanshi & Lin 2006, one closed form per
// sample in double precision. Also plays the same strikes on the synthesiser.
#pragma once

#include "Support/Larger.h"
#include "Support/Phasor.h"
#include "Support/SyntheticObject.h"
#include "Synth/Synthesiser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

namespace idiophone::test {

struct ReferenceMode {
    double stiffness = 0; ///< λ
    double damping = 0;   ///< γ + χ √λ + η λ
    /// g / m. The imaginary part gives v̇ + α v over the damped frequency.
    std::complex<double> residue = 0;
};

/// A synthetic object with fluid damping only, by default so light that it still rings after 10 s.
inline ModalObject ringingObject(const std::vector<double>& frequenciesHz,
                                 double fluidDamping = 0.5,
                                 std::vector<float> gains = {}) {
    ModalObject object = syntheticObject(frequenciesHz, std::move(gains));
    object.material.damping.fluidPerSecond = fluidDamping;
    object.material.damping.viscoelasticSeconds = 0;
    return object;
}

inline ReferenceMode
referenceMode(const Material& material, double frequencyHz, std::complex<double> residue) {
    const double lambda = std::pow(2 * std::numbers::pi * frequencyHz, 2);
    const auto& [gamma, eta, loss] = material.damping;
    return {lambda, gamma + loss * std::sqrt(lambda) + eta * lambda, residue};
}

/// Returns the sound `seconds` after a unit impulse: eq. 6 for ω±, eq. 10 for c, eq. 11 for v. The
/// imaginary part of the residue gives v̇ + α v, without the impulse itself.
inline double impulseVelocity(const ReferenceMode& mode, double seconds) {
    if (seconds < 0)
        return 0;
    const std::complex<double> root =
        std::sqrt(std::complex<double>(mode.damping * mode.damping - 4 * mode.stiffness));
    const std::complex<double> plus = (-mode.damping + root) / 2.0;
    const std::complex<double> minus = (-mode.damping - root) / 2.0;
    const std::complex<double> c = 1.0 / (plus - minus);
    const auto first = c * plus * std::exp(plus * seconds);
    const auto second = -c * minus * std::exp(minus * seconds);
    const double velocity = (first + second).real();
    if (mode.residue.imag() == 0)
        return mode.residue.real() * velocity;
    const double alpha = mode.damping / 2;
    const double omega = std::sqrt(mode.stiffness - alpha * alpha);
    const double acceleration = (plus * first + minus * second).real();
    return mode.residue.real() * velocity +
           mode.residue.imag() * (acceleration + alpha * velocity) / omega;
}

/// Returns the velocity after a raised-cosine pulse of unit impulse, by 16-point Gauss-Legendre
/// quadrature of the convolution on panels of at most four radians. `extraDamping` multiplies the
/// response by e^{−δt}.
inline double pulseVelocity(const ReferenceMode& mode,
                            double contactSeconds,
                            double seconds,
                            double extraDamping = 0) {
    static constexpr std::array nodes{0.0950125098376374, 0.2816035507792589, 0.4580167776572274,
                                      0.6178762444026438, 0.7554044083550030, 0.8656312023878318,
                                      0.9445750230732326, 0.9894009349916499};
    static constexpr std::array weights{0.1894506104550685, 0.1826034150449236, 0.1691565193950025,
                                        0.1495959888165767, 0.1246289712555339, 0.0951585116824928,
                                        0.0622535239386479, 0.0271524594117541};
    const double until = std::min(seconds, contactSeconds);
    if (until <= 0)
        return 0;
    const double omega = 2 * std::numbers::pi / contactSeconds;
    const double fastest = std::max(omega, std::sqrt(mode.stiffness) + mode.damping);
    const int panels = 1 + static_cast<int>(until * fastest / 4);
    const double half = until / panels / 2;
    double sum = 0;
    for (int panel = 0; panel < panels; ++panel)
        for (std::size_t k = 0; k < nodes.size(); ++k)
            for (const double side : {-1.0, 1.0}) {
                const double at = half * (2 * panel + 1 + side * nodes[k]);
                const double force = (1 - std::cos(omega * at)) / contactSeconds;
                sum += half * weights[k] * force * std::exp(-extraDamping * (seconds - at)) *
                       impulseVelocity(mode, seconds - at);
            }
    if (mode.residue.imag() != 0 && seconds < contactSeconds) {
        // Add the force itself, because an impulse makes v̇ jump.
        const double alpha = mode.damping / 2;
        sum += mode.residue.imag() / std::sqrt(mode.stiffness - alpha * alpha) *
               (1 - std::cos(omega * seconds)) / contactSeconds;
    }
    return sum;
}

struct TimedStrike {
    double sample = 0; ///< from the start of the stream
    Strike strike;
    std::size_t slot = 0;
};

/// A strike of unit impulse straight into vertex 0 of a synthetic object, with residue gain².
inline Strike unitStrike(double durationSeconds = 0) {
    Strike strike;
    strike.impulseNewtonSeconds = {0, 0, -1};
    strike.durationSeconds = durationSeconds;
    return strike;
}

/// Settings that truncate, merge and leave out nothing.
inline SynthesisSettings exactSettings() {
    SynthesisSettings settings;
    settings.tau = 0;
    settings.compression = 0;
    settings.modeBudget = 1e6;
    return settings;
}

using BeforeCell = std::function<void(int cell)>;

inline std::vector<float> render(Synthesiser& synthesiser,
                                 const std::vector<TimedStrike>& strikes,
                                 int cells,
                                 const BeforeCell& beforeCell = {}) {
    std::vector<float> output;
    std::array<float, cellSamples> cell{};
    for (int c = 0; c < cells; ++c) {
        if (beforeCell)
            beforeCell(c);
        synthesiser.beginCell(cell);
        for (const TimedStrike& timed : strikes) {
            const double within = timed.sample - static_cast<double>(c) * cellSamples;
            if (within >= 0 && within < cellSamples)
                synthesiser.strike(timed.slot, timed.strike, within, cell);
        }
        output.insert(output.end(), cell.begin(), cell.end());
    }
    return output;
}

inline SynthesiserSlot slotOf(ModalObject object, double sizeRatio = 1) {
    return {std::make_shared<const ModalObject>(std::move(object)), sizeRatio};
}

/// Returns the largest difference from `expected(sample)` over [from, to), in dB relative to the
/// largest expected value of the whole signal.
inline double errorDb(const std::vector<float>& signal,
                      const std::function<double(double)>& expected,
                      std::size_t from = 0,
                      std::size_t to = static_cast<std::size_t>(-1)) {
    double peak = 0;
    double error = 0;
    for (std::size_t k = 0; k < signal.size(); ++k) {
        const double value = expected(static_cast<double>(k));
        peak = larger(peak, std::abs(value));
        if (k >= from && k < to)
            error = larger(error, std::abs(static_cast<double>(signal[k]) - value));
    }
    return 20 * std::log10(error / peak + 1e-30);
}

/// Returns the largest level above 5 kHz in any frame of 512 samples, in dB of a full-scale
/// sinusoid.
inline double broadbandDb(std::span<const float> signal, double sampleRate) {
    constexpr std::size_t frame = 512;
    double largest = 0;
    for (std::size_t start = 0; start + frame <= signal.size(); start += frame / 4)
        for (double hz = 5000; hz < 21000; hz += 700) {
            const auto phasor = phasorAt(signal.subspan(start, frame), hz, sampleRate);
            largest = larger(largest, std::abs(phasor) / (frame / 2.0));
        }
    return 20 * std::log10(largest);
}

} // namespace idiophone::test
