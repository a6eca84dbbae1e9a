// SPDX-License-Identifier: Apache-2.0
#include "Synth/ModalPole.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {

namespace {

// Near critical damping the two terms diverge. Widening the gap of the roots to a tenth of α keeps
// a true bound, because sinh(βt)/β grows with β.
constexpr double minimumGap = 0.1;

double rootGap(const ModalPole& pole) noexcept {
    const double alpha = pole.damping / 2;
    const double gap = std::sqrt(std::max(alpha * alpha - pole.stiffness, 0.0));
    return std::max(gap, minimumGap * alpha);
}

Propagator heavilyDamped(const ModalPole& pole, double seconds) noexcept {
    const double alpha = pole.damping / 2;
    const double discriminant = alpha * alpha - pole.stiffness;
    double even = 0; // e^{−αt} cosh βt
    double odd = 0;  // e^{−αt} sinh(βt)/β
    if (discriminant > 0) {
        const double beta = std::sqrt(discriminant);
        const double slow = std::exp(-pole.stiffness / (alpha + beta) * seconds);
        const double fall = -std::expm1(-2 * beta * seconds);
        even = slow * (1 - fall / 2);
        odd = slow * fall / (2 * beta);
    } else {
        const double omega = std::sqrt(-discriminant);
        const double decay = std::exp(-alpha * seconds);
        even = decay * std::cos(omega * seconds);
        odd = omega > 0 ? decay * std::sin(omega * seconds) / omega : decay * seconds;
    }
    const double natural = std::sqrt(pole.stiffness);
    return {even - alpha * odd, -natural * odd, natural * odd, even + alpha * odd};
}

} // namespace

ModalPole PoleLaw::pole(double referenceEigenvalue, const ModeDamping& mode) const noexcept {
    const double lambda = stiffness(referenceEigenvalue);
    const double ofMaterial = mode.scale * damping.perSecond(lambda);
    const double extra = mode.extraPerSecond > 0 ? 2 * mode.extraPerSecond * extraFactor() : 0;
    return {lambda, std::clamp(ofMaterial + extra, 0.0, largestDamping)};
}

// λ − α² − ω² rises with λ while α² < λ/2. The law has no power of λ above the first, so its double
// root is at 2ω² or beyond. Newton's method from ω² approaches from below.
double stiffnessSoundingAt(double dampedFrequency,
                           const DampingLaw& damping,
                           const ModeDamping& mode,
                           double referenceEigenvalue) noexcept {
    constexpr int maximumSteps = 20;
    constexpr double minimumSlope = 0.1; // bounds the steps near the double root
    const double target = dampedFrequency * dampedFrequency;
    double stiffness = target;
    for (int step = 0; step < maximumSteps; ++step) {
        const double extra = mode.extraPerSecond * std::sqrt(stiffness / referenceEigenvalue);
        const double alpha = mode.scale * damping.perSecond(stiffness) / 2 + extra;
        const double alphaSlope =
            mode.scale *
                (damping.viscoelasticSeconds + damping.lossFactor / (2 * std::sqrt(stiffness))) /
                2 +
            extra / (2 * stiffness);
        const double miss = stiffness - alpha * alpha - target;
        const double slope = std::max(1 - 2 * alpha * alphaSlope, minimumSlope);
        const double next = std::clamp(stiffness - miss / slope, target, 2 * target);
        if (std::abs(next - stiffness) <= 1e-13 * stiffness)
            return next;
        stiffness = next;
    }
    return stiffness;
}

double naturalFrequencyHz(const ModalPole& pole) noexcept {
    return std::sqrt(pole.stiffness) / (2 * std::numbers::pi);
}

double dampedFrequency(const ModalPole& pole) noexcept {
    return std::sqrt(std::max(pole.stiffness - pole.damping * pole.damping / 4, 0.0));
}

Propagator propagator(const ModalPole& pole, double seconds) noexcept {
    if (!isOscillating(pole))
        return heavilyDamped(pole, seconds);
    const double decay = std::exp(-pole.damping / 2 * seconds);
    const double angle = dampedFrequency(pole) * seconds;
    const double re = decay * std::cos(angle);
    const double im = decay * std::sin(angle);
    return {re, -im, im, re};
}

ModalState stateOf(const ModalPole& pole, const Motion& motion) noexcept {
    if (!isOscillating(pole))
        return {motion.velocity, std::sqrt(pole.stiffness) * motion.displacement};
    const double force = pole.stiffness * motion.displacement + pole.damping / 2 * motion.velocity;
    return {motion.velocity, force / dampedFrequency(pole)};
}

Motion motionOf(const ModalPole& pole, const ModalState& state) noexcept {
    if (!isOscillating(pole))
        return {state.x, state.y / std::sqrt(pole.stiffness)};
    const double force = state.y * dampedFrequency(pole) - pole.damping / 2 * state.x;
    return {state.x, force / pole.stiffness};
}

double amplitudeBound(const ModalPole& pole, const ModalState& state) noexcept {
    if (isOscillating(pole))
        return std::sqrt(state.x * state.x + state.y * state.y);
    const double slope = pole.damping / 2 * state.x + std::sqrt(pole.stiffness) * state.y;
    return std::max(std::abs(state.x), std::abs(slope) / rootGap(pole));
}

double decayBound(const ModalPole& pole) noexcept {
    const double alpha = pole.damping / 2;
    if (isOscillating(pole))
        return alpha;
    const double gap = rootGap(pole);
    // α − β without the cancellation at heavy over-damping.
    return gap > minimumGap * alpha ? pole.stiffness / (alpha + gap) : alpha - gap;
}

} // namespace idiophone
