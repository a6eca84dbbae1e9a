#include "Synth/ContactPulse.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {

namespace {

// Complex arithmetic written out: the library's checks for infinities at every product cost more
// than the product.
std::complex<double> product(std::complex<double> a, std::complex<double> b) noexcept {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

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
    // Not as a sum: λ − Ω² near resonance is exact when formed first.
    const double real = (delta * delta + pole.damping * delta) + (pole.stiffness - omega * omega);
    swingStiffness = {real, stiffnessIncrease.imag()};
    steady = contactRate * delta / constantStiffness;
    swing = -contactRate * quotient({delta, omega}, swingStiffness);
}

Motion ForcedResponse::motion(std::complex<double> phase) const noexcept {
    // 1/P(δ) − e^{iΩt}/P(δ + iΩ) over a common denominator: at phase 1 the difference is small.
    const auto numerator = stiffnessIncrease + constantStiffness * (1.0 - phase);
    const auto displacement = quotient(numerator, constantStiffness * swingStiffness);
    return {steady + product(swing, phase).real(), contactRate * displacement.real()};
}

double contactSecondsClearOf(std::span<const double> resonancesHz, double seconds) noexcept {
    constexpr double tooNear = 0.01;
    double best = distanceFrom(resonancesHz, seconds);
    double chosen = seconds;
    if (best >= tooNear)
        return chosen;
    for (const double candidate : {seconds * (1 + tooNear), seconds * (1 - tooNear)}) {
        const double distance = distanceFrom(resonancesHz, candidate);
        if (distance > best) {
            best = distance;
            chosen = candidate;
        }
    }
    return chosen;
}

} // namespace idiophone
