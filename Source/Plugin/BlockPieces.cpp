#include "Plugin/BlockPieces.h"

#include "Instrument/MidiControllers.h"

#include <algorithm>

namespace idiophone {
namespace {

bool isChannelMessage(const juce::MidiMessageMetadata& metadata) {
    return metadata.numBytes >= 1 && metadata.numBytes <= 3 && metadata.data[0] >= 0x80 &&
           metadata.data[0] < 0xf0;
}

bool isAllSoundOff(const juce::MidiMessageMetadata& metadata) {
    return midi::isAllSoundOff({metadata.data, static_cast<std::size_t>(metadata.numBytes)});
}

bool isSystemExclusive(const juce::MidiMessageMetadata& metadata) {
    return metadata.numBytes >= 1 && metadata.data[0] == 0xf0;
}

} // namespace

void BlockPieces::begin(const juce::MidiBuffer& midi, int blockSamples) noexcept {
    message = midi.cbegin();
    lastMessage = midi.cend();
    position = 0;
    samples = blockSamples;
    finished = false;
}

// Some hosts give events a time outside their block.
int BlockPieces::stampOf(const juce::MidiMessageMetadata& metadata) const noexcept {
    return std::clamp(metadata.samplePosition, position, std::max(position, samples - 1));
}

// Returns how far samples and events fit. Ends before a sample whose events do not all fit.
int BlockPieces::pieceEnd() const noexcept {
    const int end = std::min(position + maximumSamples, samples);
    auto count = eventCount;
    for (auto later = message; later != lastMessage; ++later) {
        const int stamp = stampOf(*later);
        if ((isSystemExclusive(*later) || isAllSoundOff(*later)) && stamp > position && stamp < end)
            return stamp;
        if (!isChannelMessage(*later))
            continue;
        if (stamp >= end)
            break;
        if (count++ == events.size())
            return stamp;
    }
    return end;
}

std::optional<BlockPieces::Piece> BlockPieces::next() noexcept {
    if (finished)
        return std::nullopt;
    const int start = position;
    int end = pieceEnd();
    std::span<const juce::uint8> systemExclusive;
    for (; message != lastMessage; ++message) {
        const auto metadata = *message;
        const int stamp = stampOf(metadata);
        if (isSystemExclusive(metadata)) {
            if (stamp >= end && end > start)
                break;
            if (eventCount > 0 || !systemExclusive.empty()) {
                end = start;
                break;
            }
            systemExclusive = {metadata.data, static_cast<std::size_t>(metadata.numBytes)};
        }
        if (!isChannelMessage(metadata))
            continue;
        if ((stamp >= end && end > start) || eventCount == events.size())
            break;
        auto& event = events[eventCount++];
        event = {.sampleOffset = stamp - start, .bytes = {}};
        std::copy_n(metadata.data, metadata.numBytes, event.bytes.begin());
    }
    position = end;
    finished = end >= samples && message == lastMessage;
    if (finished && samples == 0 && systemExclusive.empty())
        return std::nullopt;
    return Piece{.start = start,
                 .length = end - start,
                 .systemExclusive = systemExclusive,
                 .events = std::span(events).first(std::exchange(eventCount, 0))};
}

} // namespace idiophone
