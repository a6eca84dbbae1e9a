// The tracks of a Standard MIDI File, as they stand in it.
#pragma once

#include <juce_audio_basics/juce_audio_basics.h>
#include <optional>
#include <string_view>
#include <vector>

namespace idiophone {

struct MidiTracks {
    short timeFormat = 0;                               ///< as juce::MidiFile::getTimeFormat
    std::vector<std::vector<juce::MidiMessage>> tracks; ///< in order of time, which is in ticks
};

/// What juce::MidiFile reads, or nothing where that is damaged or cut off. JUCE itself looks for
/// the end of each note among all messages of its time, which takes quadratic time.
std::optional<MidiTracks> readMidiTracks(std::string_view bytes);

} // namespace idiophone
