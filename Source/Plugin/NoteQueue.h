// Notes from the on-screen keyboard to the audio thread, without a lock on either side.
#pragma once

#include "Instrument/Player.h"

#include <array>
#include <juce_core/juce_core.h>

namespace idiophone {

class NoteQueue {
public:
    static constexpr int capacity = 256;

    /// [message thread] Velocity 0 releases. Returns false, and forgets the note, where the audio
    /// thread has not read for so long that the queue is full.
    bool push(int note, int velocity) noexcept {
        const auto scope = fifo.write(1);
        if (scope.blockSize1 + scope.blockSize2 == 0)
            return false;
        const auto status = static_cast<std::uint8_t>(velocity > 0 ? 0x90 : 0x80);
        const auto index =
            static_cast<std::size_t>(scope.blockSize1 > 0 ? scope.startIndex1 : scope.startIndex2);
        events[index] = {.sampleOffset = 0,
                         .bytes = {status, static_cast<std::uint8_t>(note & 127),
                                   static_cast<std::uint8_t>(velocity & 127)}};
        return true;
    }

    /// [audio thread] Hands each waiting note to `take`, oldest first; at most `capacity` of them.
    template <class Take>
    void read(Take&& take) noexcept {
        const auto scope = fifo.read(fifo.getNumReady());
        scope.forEach([&](int index) { take(events[static_cast<std::size_t>(index)]); });
    }

private:
    juce::AbstractFifo fifo{capacity};
    std::array<MidiEvent, capacity> events{};
};

} // namespace idiophone
