// The tracks of a Standard MIDI File in their original order.
#pragma once

#include <juce_audio_basics/juce_audio_basics.h>
#include <optional>
#include <string_view>
#include <vector>

namespace idiophone {

struct MidiTracks {
    short timeFormat = 0;                               ///< as in juce::MidiFile::getTimeFormat
    std::vector<std::vector<juce::MidiMessage>> tracks; ///< in order of time; times are in ticks
};

/// Reads the same as juce::MidiFile, or nothing if the file is damaged or cut off. JUCE searches
/// all messages of a time for the end of each note, which takes quadratic time.
std::optional<MidiTracks> readMidiTracks(std::string_view bytes);

} // namespace idiophone
