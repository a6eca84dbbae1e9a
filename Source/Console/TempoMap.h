// The time of a Standard MIDI File in seconds.
#pragma once

#include "Console/MidiTracks.h"

#include <vector>

namespace idiophone {

/// Whether it tells a tempo, all of it.
bool isTempo(const juce::MidiMessage& message);

/// As juce::MidiFile::convertTimestampTicksToSeconds counts, to the same bits; that one goes
/// through all changes of tempo for each message, which takes quadratic time.
class TempoMap {
public:
    /// Of a file whose time format is not 0 in any part.
    explicit TempoMap(const MidiTracks& midi);

    double secondsAt(double ticks) const;

private:
    /// From a tick on, until the next one.
    struct Stretch {
        double fromTicks = 0;
        double fromSeconds = 0;
        double secondsPerTick = 0;
    };

    int timeFormat;
    std::vector<Stretch> stretches; ///< in order of time
};

} // namespace idiophone
