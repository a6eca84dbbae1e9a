// Plays events on a player into a recording, block by block, as a host would.
#pragma once

#include "Console/MidiSong.h"
#include "Console/Recording.h"
#include "Instrument/Player.h"

#include <span>

namespace idiophone {

/// What rendering found out besides the sound; a cell is 64 samples.
struct RenderTally {
    std::int64_t strikes = 0;
    std::int64_t notesWithoutKey = 0; ///< beside the strikes
    std::int64_t cells = 0; ///< at whose end modes were counted: every one up to block size 64
    double modesMixedMean = 0;
    std::int64_t modesMixedMost = 0;
    double renderSeconds = 0; ///< measured, so for information only

    void count(std::int64_t modesMixed);
};

/// Renders up to the length of the format, or else to silence after the last event. Every event
/// acts at round(seconds × rate). `task` is what the progress line says; Ctrl-C ends in an error.
Result<RenderTally> renderSong(Player& player,
                               std::span<const SongEvent> events,
                               const ParameterValues& parameters,
                               const RecordingFormat& format,
                               Recording& recording,
                               const std::string& task);

} // namespace idiophone
