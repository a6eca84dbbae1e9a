// SPDX-License-Identifier: Apache-2.0
// The friction of a bow on a point of an object, sample by sample (docs/decisions/0039). It knows
// neither keys nor the rest of the object.
#pragma once

#include "Synth/ContactForce.h"
#include "Synth/PointModes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace idiophone {

/// The law of rosin: the coefficient of friction falls as the contact heats, after Smith &
/// Woodhouse (J. Mech. Phys. Solids 48, 2000). Heat is measured by the power per newton of pressure
/// that keeps it up.
struct BowFriction {
    static constexpr double cold = 0.8, hot = 0.3;
    static constexpr double halfwayMetresPerSecond = 0.05; ///< heat of the mean coefficient
    /// The contact cools in this angle of the mode that is softest at the place. So it is too slow
    /// for modes far above, as a bow is whose size follows the object's.
    static constexpr double coolingRadians = 0.3;

    static constexpr double coefficient(double heat) noexcept {
        return hot + (cold - hot) * halfwayMetresPerSecond / (halfwayMetresPerSecond + heat);
    }
};

/// For the audio thread; neither allocates, locks nor throws. The same calls give the same bits.
class BowedPoint {
public:
    explicit BowedPoint(double sampleRateHz) noexcept;

    /// Renders the force on the object in newtons, along the bow's motion. Speed and pressure
    /// change linearly from the previous ones to `motion` at the end of the cell. A bow that
    /// touches has its new speed at once, and its pressure in a curve whose spectrum has no nulls.
    /// `unevenness` u changes the coefficient of each sample to 1 + u times its value, at least 0.
    /// Each newton rendered is an impulse of one sample on `modes`, whose motion goes on from cell
    /// to cell by their numbers. Returns whether the cell holds anything but zeros.
    ///
    /// The force never exceeds the coefficient times the pressure, and always opposes the sliding:
    /// it does no more work on the modes than the bow does on the force.
    bool render(const PointModes& modes,
                const ContactMotion& motion,
                std::span<const float, cellSamples> unevenness,
                std::span<float, cellSamples> newtons) noexcept;

    /// Returns the velocity of the point at the end of the last cell, in m/s.
    double velocity() const noexcept;

    /// Puts the modes to rest, and lifts and cools the bow.
    void reset() noexcept;

private:
    void keepStatesOf(const PointModes& modes) noexcept;

    double sampleSeconds;
    double speed = 0, pressure = 0, heat = 0;
    std::size_t count = 0; ///< modes in motion
    std::array<std::int32_t, PointModes::capacity> numbers{};
    alignas(64) std::array<float, PointModes::capacity> stateRe{}, stateIm{};
};

} // namespace idiophone
