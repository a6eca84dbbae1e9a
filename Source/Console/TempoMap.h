// Converts the times of a Standard MIDI File to seconds.
#pragma once

#include "Console/MidiTracks.h"

#include <vector>

namespace idiophone {

/// Returns whether the message is a complete tempo event.
bool isTempo(const juce::MidiMessage& message);

/// Gives the same bits as juce::MidiFile::convertTimestampTicksToSeconds, except in the SMPTE
/// format of 29 frames, where JUCE is 3 % slow. JUCE goes through all tempo changes for each
/// message, which takes quadratic time.
class TempoMap {
public:
    /// Expects a time format that has no part equal to 0.
    explicit TempoMap(const MidiTracks& midi);

    double secondsAt(double ticks) const;

private:
    /// The time from one tempo change to the next.
    struct Stretch {
        double fromTicks = 0;
        double fromSeconds = 0;
        double secondsPerTick = 0;
    };

    int timeFormat;
    std::vector<Stretch> stretches; ///< in order of time
};

} // namespace idiophone
