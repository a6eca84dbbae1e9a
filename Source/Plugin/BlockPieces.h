// Cuts a host's block into pieces whose MIDI and samples fit fixed buffers. A crowded or overlong
// block neither allocates nor loses anything.
#pragma once

#include "Instrument/Player.h"

#include <array>
#include <juce_audio_basics/juce_audio_basics.h>
#include <optional>
#include <span>

namespace idiophone {

/// For the audio thread; neither allocates, locks nor throws.
class BlockPieces {
public:
    static constexpr int maximumSamples = 1024;
    /// The strikes that a synthesiser takes at once: 64 contacts on each of 128 keys.
    static constexpr int maximumEvents = 64 * 128;

    /// Valid until the next call of `next`. "All sound off" starts a piece, so that the output
    /// stage can follow it at its sample. `length` is 0 if more events fall on one sample than fit,
    /// or if some of them come before a system exclusive message.
    struct Piece {
        int start = 0;
        int length = 0;
        std::span<const juce::uint8> systemExclusive; ///< applies before the events; empty: none
        std::span<const MidiEvent> events;            ///< channel messages, offsets from `start`
    };

    /// Starts a block; `midi` must live until its last piece. Skips other system messages. Keeps
    /// the events of a block without samples for the next block, unless a system exclusive message
    /// comes with them.
    void begin(const juce::MidiBuffer& midi, int blockSamples) noexcept;

    /// Returns how many events fit now.
    std::size_t room() const noexcept { return events.size() - eventCount; }
    /// Adds an event at the block's first sample, before its MIDI. Call it before `next`, and only
    /// while there is room.
    void add(const MidiEvent& event) noexcept { events[eventCount++] = event; }

    /// Reads each message at most twice per block.
    std::optional<Piece> next() noexcept;

    /// Forgets the events kept for the next block.
    void reset() noexcept { eventCount = 0; }

private:
    int stampOf(const juce::MidiMessageMetadata& metadata) const noexcept;

    juce::MidiBufferIterator message, lastMessage;
    int position = 0;
    int samples = 0;
    bool finished = true;
    std::array<MidiEvent, maximumEvents> events{};
    std::size_t eventCount = 0; ///< collected and not yet returned
};

} // namespace idiophone
