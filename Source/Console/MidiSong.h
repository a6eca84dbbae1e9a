// A Standard MIDI File as one stream of channel messages in seconds.
#pragma once

#include "Object/Result.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace idiophone {

struct SongEvent {
    double seconds = 0;
    std::array<std::uint8_t, 3> bytes{}; ///< two-byte messages have a 0 behind them

    bool isNoteOn() const { return (bytes[0] & 0xf0) == 0x90 && bytes[2] > 0; }
    bool isNoteOff() const {
        return (bytes[0] & 0xf0) == 0x80 || ((bytes[0] & 0xf0) == 0x90 && bytes[2] == 0);
    }
};

/// The channel messages of all tracks, in order of time by the file's tempo map or SMPTE rate. At
/// one time those of a track keep its order, but what ends a note comes before what strikes its key
/// again, and pressure is that of the keys that go down then.
/// Among tracks controllers come first, then note-offs, then note-ons.
/// The error names the file and the fault: not a MIDI file, damaged, no notes, beyond 10 hours.
Result<std::vector<SongEvent>> readMidiSong(const std::filesystem::path& file);

} // namespace idiophone
