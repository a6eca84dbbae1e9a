// SPDX-License-Identifier: Apache-2.0
#include "Synth/ContactPulse.h"

#include "Synth/ComplexProduct.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace idiophone {

namespace {

std::complex<double> quotient(std::complex<double> a, std::complex<double> b) noexcept {
    return product(a, std::conj(b)) / std::norm(b);
}

double distanceFrom(std::span<const double> resonancesHz, double seconds) noexcept {
    double nearest = 1;
    for (const double hz : resonancesHz)
        nearest = std::min(nearest, std::abs(hz * seconds - 1));
    return nearest;
}

} // namespace

ForcedResponse::ForcedResponse(const ModalPole& pole,
                               double contactSeconds,
                               double dampingPerSecond) noexcept
    : contactRate(1 / contactSeconds) {
    const double omega = 2 * std::numbers::pi * contactRate;
    const double delta = dampingPerSecond;
    constantStiffness = delta * delta + pole.damping * delta + pole.stiffness;
    stiffnessIncrease = {-omega * omega, omega * (2 * delta + pole.damping)};
    // Form λ − Ω² first: near resonance it is exact, and a sum from the left is not.
    double real = (delta * delta + pole.damping * delta) + (pole.stiffness - omega * omega);
    // At an undamped resonance, keep the denominator away from 0: the limit is finite.
    const double nearest = 1e-9 * omega * omega;
    if (std::abs(real) < nearest && std::abs(stiffnessIncrease.imag()) < nearest)
        real = std::copysign(nearest, real);
    swingStiffness = {real, stiffnessIncrease.imag()};
    steady = contactRate * delta / constantStiffness;
    swing = -contactRate * quotient({delta, omega}, swingStiffness);
}

Motion ForcedResponse::motion(std::complex<double> phase) const noexcept {
    // 1/P(δ) − e^{iΩt}/P(δ + iΩ) over a common denominator, because the difference is small at
    // phase 1.
    const auto numerator = stiffnessIncrease + constantStiffness * (1.0 - phase);
    const auto displacement = quotient(numerator, constantStiffness * swingStiffness);
    return {steady + product(swing, phase).real(), contactRate * displacement.real()};
}

double contactSecondsClearOf(std::span<const double> resonancesHz, double seconds) noexcept {
    // Further resonances are far enough from every candidate.
    constexpr double near = 0.05;
    std::array<double, 64> nearHz;
    std::size_t count = 0;
    for (std::size_t i = 0; i < resonancesHz.size() && count < nearHz.size(); ++i)
        if (std::abs(resonancesHz[i] * seconds - 1) < near)
            nearHz[count++] = resonancesHz[i];
    if (count < nearHz.size())
        resonancesHz = std::span(nearHz).first(count);
    // If a contact equals a resonance's period to the last bit, rounding must not decide.
    constexpr double rounding = 1e-6;
    constexpr double farEnough = 0.01 - rounding;
    double best = distanceFrom(resonancesHz, seconds);
    double chosen = seconds;
    for (int step = 1; best < farEnough && step <= 6; ++step)
        for (const double shift : {0.005 * step, -0.005 * step}) {
            const double candidate = seconds * (1 + shift);
            const double distance = distanceFrom(resonancesHz, candidate);
            if (distance > best + rounding && best < farEnough) {
                best = distance;
                chosen = candidate;
            }
        }
    return chosen;
}

} // namespace idiophone
