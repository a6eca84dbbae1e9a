// The bars of the factory's instruments, before they are tuned.
#pragma once

#include "Analysis/BarTuning.h"

namespace idiophone {

/// The equal-tempered frequency of a MIDI note, A4 (69) = 440 Hz.
double noteFrequencyHz(int midiNote);

inline constexpr int lowestXylophoneNote = 72, highestXylophoneNote = 108;

/// The rosewood xylophone's bar for a note from 72 to 108, named "xylophone-72" and so on. Uniform
/// bars (no arch) grow a little thicker towards the treble, which keeps the top ones long enough to
/// be struck.
BarSpecification rosewoodXylophoneBar(int midiNote);

} // namespace idiophone
