// The tracks of a Standard MIDI File in their original order.
#pragma once

#include "Object/Result.h"

#include <juce_audio_basics/juce_audio_basics.h>
#include <string>
#include <string_view>
#include <vector>

namespace idiophone {

struct MidiTracks {
    short timeFormat = 0; ///< as in juce::MidiFile::getTimeFormat
    /// In order of time; times are in ticks. System exclusive messages are whole, from F0 to F7.
    std::vector<std::vector<juce::MidiMessage>> tracks;
    std::vector<std::string> oddities; ///< a sentence for each; the file was read all the same
};

/// Reads all tracks. The header may stand in a RIFF file or behind other bytes. Track lengths may
/// be wrong, if each such track has its end event. The error is the end of a sentence that begins
/// with the file's name.
/// JUCE's own reader takes packets of system exclusive messages for notes, and searches all
/// messages of a time for the end of each note, which takes quadratic time.
Result<MidiTracks> readMidiTracks(std::string_view bytes);

} // namespace idiophone
