// Hands notes from the on-screen keyboard to the audio thread.
#pragma once

#include "Instrument/Player.h"
#include "Plugin/OneWayQueue.h"

#include <atomic>
#include <bitset>

namespace idiophone {

class NoteQueue {
public:
    static constexpr int capacity = 256;
    /// Maximum events of one `read`: the queue and a release of every key.
    static constexpr int mostEvents = capacity + 128;

    /// [message thread] Queues a note; velocity 0 releases it. If the queue is full, drops the note
    /// and returns false. If it drops a release, the next `read` releases all keys.
    bool push(int note, int velocity) noexcept {
        const bool isRelease = velocity <= 0;
        const bool isQueued = queue.push(isRelease ? release(note) : strike(note, velocity));
        if (!isQueued && isRelease)
            releaseLost = true;
        return isQueued;
    }

    /// [audio thread] Hands each pending note to `take`, oldest first; at most `mostEvents`.
    template <class Take>
    void read(Take&& take) noexcept {
        queue.read([&](const MidiEvent& event) {
            held.set(event.bytes[1], event.bytes[0] == noteOn);
            take(event);
        });
        if (!releaseLost.exchange(false))
            return;
        for (std::size_t note = 0; note < held.size(); ++note)
            if (held.test(note))
                take(release(static_cast<int>(note)));
        held.reset();
    }

    /// [audio thread] Discards all pending notes; call when all keys are up.
    void clear() noexcept {
        queue.read([](const MidiEvent&) {});
        releaseLost = false;
        held.reset();
    }

private:
    static constexpr std::uint8_t noteOn = 0x90, noteOff = 0x80;

    static MidiEvent strike(int note, int velocity) noexcept {
        return {.sampleOffset = 0,
                .bytes = {noteOn, static_cast<std::uint8_t>(note & 127),
                          static_cast<std::uint8_t>(velocity & 127)}};
    }
    static MidiEvent release(int note) noexcept {
        return {.sampleOffset = 0, .bytes = {noteOff, static_cast<std::uint8_t>(note & 127), 0}};
    }

    OneWayQueue<MidiEvent, capacity> queue;
    std::atomic<bool> releaseLost{false}; ///< because the queue was full
    std::bitset<128> held;                ///< the audio thread's
};

} // namespace idiophone
