// Texts about objects and their modes: name, level, frequency, note, decay time and state.
#pragma once

#include "Editor/InstrumentView.h"
#include "Editor/SoundView.h"

#include <juce_core/juce_core.h>
#include <optional>

namespace idiophone {

/// Modes at or below this level, in dB of full scale, are not shown.
inline constexpr double faintestDecibels = -150;

/// Level of a velocity amplitude in m/s, where full scale is 1. At least `faintestDecibels`.
double decibelsOf(double metresPerSecond);

/// "440 Hz", "12.3 kHz": three or four digits.
juce::String frequencyText(double frequencyHz);
/// "85 ms", "2.31 s".
juce::String secondsText(double seconds);
/// "A4" for MIDI note 69.
juce::String noteName(int midiNote);
/// "C2" or "C2–B2".
juce::String keysText(InstrumentView::KeyRange keys);
/// Parses "A4", "f#3", "Bb2" or "69". Returns nothing if it is no MIDI note.
std::optional<int> parseNoteName(const juce::String& text);
/// The name of an object, behind its note if one key alone plays it.
juce::String objectText(const InstrumentView::PlayedObject& played);
/// The nearest note and the deviation in cents: "A4 +3 ct", with A4 = 440 Hz. Empty outside the
/// MIDI range.
juce::String noteText(double frequencyHz);
/// The state of a mode: "sounding", "below the threshold" ...
juce::String standingText(const ModeNow& mode);

/// Two lines on an existing mode: frequency, note and T60; then level, state and group.
juce::StringArray describeMode(const SoundFrame& frame, std::size_t mode);

} // namespace idiophone
