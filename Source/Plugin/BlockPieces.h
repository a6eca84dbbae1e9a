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
    static constexpr int maximumEvents = 1024;

    /// Valid until the next `next`. `length` may be 0 where only events are left: more of them fall
    /// on one sample than fit, or the host sent a block without samples.
    struct Piece {
        int start = 0;
        int length = 0;
        std::span<const MidiEvent> events; ///< channel messages, offsets from `start`
    };

    /// Starts a block; `midi` must live until its last piece. Waiting notes of the queue sound at
    /// its first sample. System messages and those longer than three bytes are left out.
    void begin(const juce::MidiBuffer& midi, NoteQueue& notes, int blockSamples) noexcept;

    std::optional<Piece> next() noexcept;

private:
    int stampOf(const juce::MidiMessageMetadata& metadata) const noexcept;
    int pieceEnd() const noexcept;
    void append(int sampleOffset, std::span<const juce::uint8> bytes) noexcept;

    juce::MidiBufferIterator message, lastMessage;
    int position = 0;
    int samples = 0;
    bool finished = true;
    std::array<MidiEvent, maximumEvents> events{};
    std::size_t eventCount = 0;
    static_assert(NoteQueue::capacity <= maximumEvents);
};

} // namespace idiophone
