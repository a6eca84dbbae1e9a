// Events and strikes in their order of time.
#pragma once

#include "Instrument/MidiEvent.h"
#include "Instrument/StrikeScheduler.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace idiophone {

/// Returns the leading events up to a sample, from events in order of time.
inline std::span<const MidiEvent> dueAt(int sample, std::span<const MidiEvent> events) {
    const auto later = std::ranges::find_if(
        events, [sample](const MidiEvent& event) { return event.sampleOffset > sample; });
    return {events.begin(), later};
}

/// Returns a strike number that is the same for all places near a beat, and 0 for the first beat. A
/// host reports a loop that ends within a block at a place after its start. The boundary is 0.1
/// beats before a beat, because songs seldom begin there.
inline std::uint32_t strikesBefore(double beats) {
    return distantNumber(
        static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(beats + 0.1))));
}

} // namespace idiophone
