// Which pitch each MIDI note has. Plain data that crosses threads by copy.
#pragma once

#include <array>
#include <bitset>

namespace idiophone {

/// By default twelve equal steps to the octave, with note 69 at 440 Hz.
struct KeyTuning {
    static constexpr int notes = 128;

    /// How far each note lies from where equal temperament has it.
    std::array<double, notes> semitonesFromEqual{};
    /// Notes that the tuning has no pitch for; they do not sound.
    std::bitset<notes> unmapped;

    bool operator==(const KeyTuning&) const = default;
};

} // namespace idiophone
