// The pitch of each MIDI note. Plain data that crosses threads by copy.
#pragma once

#include <array>
#include <bitset>

namespace idiophone {

/// The default is twelve equal steps to the octave, with note 69 at 440 Hz.
struct KeyTuning {
    static constexpr int notes = 128;

    /// Distance of each note from equal temperament, in semitones.
    std::array<double, notes> semitonesFromEqual{};
    /// Notes without a pitch in the tuning; they do not sound.
    std::bitset<notes> unmapped;

    bool operator==(const KeyTuning&) const = default;
};

} // namespace idiophone
