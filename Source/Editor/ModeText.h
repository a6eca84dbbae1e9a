// What the window says of a mode, in words and figures.
#pragma once

#include "Editor/SoundView.h"

#include <juce_core/juce_core.h>

namespace idiophone {

/// Of this and less the window shows nothing: −150 dB of full scale.
inline constexpr double faintestDecibels = -150;

/// Of a velocity amplitude in m/s, full scale 1; at least `faintestDecibels`.
double decibelsOf(double metresPerSecond);

/// "440 Hz", "12.3 kHz": three or four figures.
juce::String frequencyText(double frequencyHz);
/// "85 ms", "2.31 s".
juce::String secondsText(double seconds);
/// The nearest note and what the frequency is beside it: "A4 +3 ct", A4 = 440 Hz. Nothing where no
/// MIDI note is near.
juce::String noteText(double frequencyHz);
/// Where a mode stands: "sounding", "below the threshold" ...
juce::String standingText(const ModeNow& mode);

/// Two lines on a mode of the frame, which exists: frequency, note and T60; level, standing, group.
juce::StringArray describeMode(const SoundFrame& frame, std::size_t mode);

} // namespace idiophone
