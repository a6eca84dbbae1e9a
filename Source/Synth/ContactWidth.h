// SPDX-License-Identifier: Apache-2.0
// The width of a bow, over which an object's higher modes average (docs/decisions/0039).
#pragma once

#include "Synth/SynthesisSettings.h"

#include <array>
#include <span>

namespace idiophone {

/// The width follows the object: a mode at `halvingRatio` times the frequency of the softest one at
/// the place meets half the force, and moves the bow by half of its motion. For the audio thread.
class ContactWidth {
public:
    static constexpr double halvingRatio = 6;

    /// Returns the share of the force at a ratio to the softest mode's frequency.
    static constexpr double share(double frequencyRatio) noexcept {
        const double root = 1 + frequencyRatio * frequencyRatio / (cornerRatio * cornerRatio);
        return 1 / (root * root);
    }

    /// Turns the force of a bow into what modes meet, by their frequencies: a low-pass.
    /// `softestRadians` is the angle in which a sample turns the softest mode.
    void average(double softestRadians, std::span<float, cellSamples> newtons) noexcept;
    void reset() noexcept { states = {}; }

private:
    /// The corner of each of four equal low-passes: halvingRatio/√(√2 − 1).
    static constexpr double cornerRatio = halvingRatio / 0.6435942529055827;

    std::array<double, 4> states{};
};

} // namespace idiophone
