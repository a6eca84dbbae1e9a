// Notes from the on-screen keyboard to the audio thread.
#pragma once

#include "Instrument/Player.h"
#include "Plugin/OneWayQueue.h"

namespace idiophone {

class NoteQueue {
public:
    static constexpr int capacity = 256;

    /// [message thread] Velocity 0 releases. Returns false, and forgets the note, where the queue
    /// is full.
    bool push(int note, int velocity) noexcept {
        const auto status = static_cast<std::uint8_t>(velocity > 0 ? 0x90 : 0x80);
        return queue.push({.sampleOffset = 0,
                           .bytes = {status, static_cast<std::uint8_t>(note & 127),
                                     static_cast<std::uint8_t>(velocity & 127)}});
    }

    /// [audio thread] Hands each waiting note to `take`, oldest first; at most `capacity` of them.
    template <class Take>
    void read(Take&& take) noexcept {
        queue.read(take);
    }

private:
    OneWayQueue<MidiEvent, capacity> queue;
};

} // namespace idiophone
