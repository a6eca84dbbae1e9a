// SPDX-License-Identifier: Apache-2.0
#include "Synth/BowedPoint.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

constexpr std::size_t lanes = 8;
static_assert(PointModes::capacity % lanes == 0);

constexpr float faintest = 1e-20f; // below, numbers would become slow

/// NaN becomes 0.
double bounded(double value, double highest) noexcept {
    return value > 0 ? std::min(value, highest) : 0;
}

/// Sums lanes in a fixed order that SIMD can follow.
float sum(const std::array<float, PointModes::capacity>& values, std::size_t count) noexcept {
    std::array<float, lanes> parts{};
    for (std::size_t i = 0; i < count; i += lanes)
        for (std::size_t k = 0; k < lanes; ++k)
            parts[k] += values[i + k];
    return ((parts[0] + parts[4]) + (parts[1] + parts[5])) +
           ((parts[2] + parts[6]) + (parts[3] + parts[7]));
}

} // namespace

BowedPoint::BowedPoint(double sampleRateHz) noexcept : sampleSeconds(1 / sampleRateHz) {}

/// Lets the states follow the modes' numbers; modes that are new begin at rest.
void BowedPoint::keepStatesOf(const PointModes& modes) noexcept {
    if (count == modes.count && numbers == modes.numbers)
        return;
    const auto formerNumbers = numbers;
    const auto formerRe = stateRe, formerIm = stateIm;
    stateRe = stateIm = {};
    for (std::size_t i = 0, k = 0; i < modes.count; ++i) {
        while (k < count && formerNumbers[k] < modes.numbers[i])
            ++k;
        if (k < count && formerNumbers[k] == modes.numbers[i]) {
            stateRe[i] = formerRe[k];
            stateIm[i] = formerIm[k];
        }
    }
    numbers = modes.numbers;
    count = modes.count;
}

bool BowedPoint::render(const PointModes& modes,
                        const ContactMotion& motion,
                        std::span<const float, cellSamples> unevenness,
                        std::span<float, cellSamples> newtons) noexcept {
    keepStatesOf(modes);
    const double nextPressure = bounded(motion.normalForceNewtons, 1e9);
    const double nextSpeed = bounded(std::abs(motion.speedMetresPerSecond), 1e6);
    const double fromPressure = std::exchange(pressure, nextPressure);
    const double fromSpeed = fromPressure == 0 ? nextSpeed : speed;
    speed = nextSpeed;
    const bool presses = fromPressure > 0 || pressure > 0;
    const std::size_t used = (count + lanes - 1) / lanes * lanes;
    const double halfYield = std::max(modes.mobilityPerKg(), 0.0) * sampleSeconds / 2;
    // The share by which the heat nears its goal in a sample.
    const double warming = -std::expm1(-modes.softestRadians / BowFriction::coolingRadians);
    for (std::size_t n = 0; n < cellSamples; ++n) {
        const double fraction = static_cast<double>(n + 1) / cellSamples;
        // A touch must not be a straight ramp: its spectrum has a null at the rate of cells.
        const double reached = fromPressure == 0 ? fraction * (2 - fraction) : fraction;
        const double pressed = fromPressure + reached * (pressure - fromPressure);
        const double evenness = std::max(1 + static_cast<double>(unevenness[n]), 0.0);
        // The velocity in the middle of the impulse solves both the friction and the modes' motion.
        const double before = static_cast<double>(sum(stateRe, used));
        const double grip = BowFriction::coefficient(heat) * evenness * pressed;
        const double wanted = fromSpeed + fraction * (speed - fromSpeed) - before;
        const double sliding = std::abs(wanted) - grip * halfYield;
        double force = 0, power = 0;
        if (sliding > 0 && grip > 0) {
            force = std::copysign(grip, wanted);
            power = grip / pressed * sliding;
        } else if (sliding <= 0 && halfYield > 0) {
            force = wanted / halfYield;
        }
        heat += warming * (power - heat);
        newtons[n] = static_cast<float>(force);
        const auto impulse = static_cast<float>(force * sampleSeconds);
        for (std::size_t i = 0; i < used; ++i) {
            const float re = stateRe[i] + modes.pushRe[i] * impulse;
            const float im = stateIm[i] + modes.pushIm[i] * impulse;
            stateRe[i] = re * modes.rotationRe[i] - im * modes.rotationIm[i];
            stateIm[i] = re * modes.rotationIm[i] + im * modes.rotationRe[i];
        }
    }
    for (auto* states : {&stateRe, &stateIm})
        for (float& state : *states)
            if (std::abs(state) < faintest)
                state = 0;
    return presses;
}

double BowedPoint::velocity() const noexcept {
    return static_cast<double>(sum(stateRe, stateRe.size()));
}

void BowedPoint::reset() noexcept {
    speed = pressure = heat = 0;
    count = 0;
    numbers = {};
    stateRe = stateIm = {};
}

} // namespace idiophone
