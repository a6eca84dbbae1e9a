// Cuts a host's block into pieces whose MIDI and samples fit fixed buffers, so that neither a
// crowded nor an overlong block allocates or loses anything.
#pragma once

#include "Plugin/NoteQueue.h"

#include <array>
#include <juce_audio_basics/juce_audio_basics.h>
#include <optional>
#include <span>

namespace idiophone {

/// [audio thread] throughout; neither allocates, locks nor throws.
class BlockPieces {
public:
    static constexpr int maximumSamples = 1024;
    /// All the strikes that a synthesiser takes at a time: 64 contacts on each of 128 keys.
    static constexpr int maximumEvents = 64 * 128;

    /// Valid until the next `next`. "All sound off" is at the start of its piece, so that what
    /// sounds on behind the player can follow it at its sample. `length` is 0 where more events
    /// fall on one sample than fit, or some of them before a system exclusive message.
    struct Piece {
        int start = 0;
        int length = 0;
        std::span<const juce::uint8> systemExclusive; ///< acts before the rest; empty: none
        std::span<const MidiEvent> events;            ///< channel messages, offsets from `start`
    };

    /// Starts a block; `midi` must live until its last piece. Waiting notes of the queue sound at
    /// its first sample. Other system messages are left out. What comes in a block without samples
    /// is kept for the next, unless a system exclusive message comes with it.
    void begin(const juce::MidiBuffer& midi, NoteQueue& notes, int blockSamples) noexcept;

    std::optional<Piece> next() noexcept;

    /// Forgets what is kept for the next block.
    void reset() noexcept { eventCount = 0; }

private:
    int stampOf(const juce::MidiMessageMetadata& metadata) const noexcept;
    int pieceEnd() const noexcept;
    void append(int sampleOffset, std::span<const juce::uint8> bytes) noexcept;

    juce::MidiBufferIterator message, lastMessage;
    int position = 0;
    int samples = 0;
    bool finished = true;
    std::array<MidiEvent, maximumEvents> events{};
    std::size_t eventCount = 0; ///< collected and not yet handed out
    static_assert(NoteQueue::mostEvents <= maximumEvents);
};

} // namespace idiophone
