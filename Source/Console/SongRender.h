// Plays events on a player into a recording, block by block, as a host would.
#pragma once

#include "Console/MidiSong.h"
#include "Console/Recording.h"
#include "Instrument/Player.h"

#include <span>

namespace idiophone {

/// Figures of a rendering. A cell is 64 samples.
struct RenderTally {
    std::int64_t strikes = 0;
    std::int64_t notesWithoutKey = 0; ///< not included in `strikes`
    std::int64_t cells = 0; ///< cells at whose end modes were counted: all up to block size 64
    double modesMixedMean = 0;
    std::int64_t modesMixedMost = 0;
    double renderSeconds = 0; ///< measured, so for information only

    void count(std::int64_t modesMixed);
};

/// Renders up to the recording's length, or else to silence after the last event. Every event acts
/// at round(seconds × rate). `tunings` replace the player's tuning, from the first of their
/// messages on. `task` names the progress line. Ctrl-C ends in an error.
Result<RenderTally> renderSong(Player& player,
                               std::span<const SongEvent> events,
                               const ParameterValues& parameters,
                               Recording& recording,
                               const std::string& task,
                               std::span<const SongTuning> tunings = {});

} // namespace idiophone
