// Random notes, releases, bends and pedal moves, on the keys of `bars` and just beside them.
#pragma once

#include "Support/RenderNotes.h"

#include <random>
#include <vector>

namespace idiophone::test {

/// Returns the same events on every call, at samples from 5 to below `samples`.
inline std::vector<MidiEvent> busyEvents(int samples) {
    std::mt19937 random(3);
    std::vector<MidiEvent> events;
    for (int time = 5; time < samples; time += static_cast<int>(random() % 700)) {
        const int note = 58 + static_cast<int>(random() % 17);
        switch (random() % 8) {
        case 0:
            events.push_back(midi(time, 0xb0, 64, random() % 2 ? 127 : 0));
            break;
        case 1:
            events.push_back(midi(time, 0xe0, 0, static_cast<int>(random() % 128)));
            break;
        case 2:
            events.push_back(midi(time, 0x80, note, 0));
            break;
        default:
            events.push_back(midi(time, 0x90, note, 1 + static_cast<int>(random() % 127)));
        }
    }
    return events;
}

} // namespace idiophone::test
