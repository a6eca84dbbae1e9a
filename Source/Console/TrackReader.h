// The messages of one track of a Standard MIDI File.
#pragma once

#include <cstddef>
#include <juce_audio_basics/juce_audio_basics.h>
#include <string_view>
#include <vector>

namespace idiophone {

enum class ReadTo { endOfBytes, endOfTrack };

struct TrackContent {
    std::vector<juce::MidiMessage> messages; ///< in order of time; times are in ticks
    std::size_t bytes = 0;                   ///< read
    bool hasEnd = false;                     ///< an end-of-track event was read
    bool isDamaged = false;                  ///< ends before `ReadTo`, where no event can be read
};

/// Reads the events of a track, without its chunk's header. Packets of system exclusive messages
/// (F0, then F7) are joined. Their lengths count, not the bytes inside: some end without F7.
/// Escapes, which are F7 without a message before, are ignored.
TrackContent readTrack(std::string_view bytes, ReadTo readTo);

} // namespace idiophone
