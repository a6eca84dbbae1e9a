// A Standard MIDI File as one stream of channel messages in seconds.
#pragma once

#include "Object/Result.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace idiophone {

struct SongEvent {
    double seconds = 0;
    std::array<std::uint8_t, 3> bytes{}; ///< two-byte messages end with a 0

    bool isNoteOn() const { return (bytes[0] & 0xf0) == 0x90 && bytes[2] > 0; }
    bool isNoteOff() const {
        return (bytes[0] & 0xf0) == 0x80 || ((bytes[0] & 0xf0) == 0x90 && bytes[2] == 0);
    }
    bool isPressure() const { return (bytes[0] & 0xf0) == 0xa0 || (bytes[0] & 0xf0) == 0xd0; }
};

/// A message of the MIDI Tuning Standard.
struct SongTuning {
    double seconds = 0;
    std::vector<std::uint8_t> message; ///< from F0 to F7
};

struct MidiSong {
    std::vector<SongEvent> events;     ///< in order of time
    std::vector<SongTuning> tunings;   ///< in order of time
    std::vector<std::string> warnings; ///< sentences on what is odd in the file, with its name
};

/// Returns the channel messages of all tracks, in order of time by the file's tempo map or SMPTE
/// rate. At equal times, events of a track keep their order, with two exceptions. A note-off
/// precedes the next note-on of its key, and pressure follows the note-ons. Among tracks,
/// controllers come first, then note-offs, then note-ons. The error names the file and the fault:
/// not a MIDI file, damaged, without notes, or longer than 10 hours.
Result<MidiSong> readMidiSong(const std::filesystem::path& file);
/// Does the same with the bytes of a file that the error names.
Result<MidiSong> parseMidiSong(std::string_view bytes, const std::string& name);

} // namespace idiophone
