#include "Plugin/BlockPieces.h"

#include "Instrument/MidiControllers.h"

#include <algorithm>
#include <utility>

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

std::optional<BlockPieces::Piece> BlockPieces::next() noexcept {
    if (finished)
        return std::nullopt;
    const int start = position;
    int end = std::min(start + maximumSamples, samples);
    std::span<const juce::uint8> systemExclusive;
    int newest = start; // sample of the newest message
    auto firstOfSample = message;
    auto eventsBefore = eventCount;
    for (; message != lastMessage; ++message) {
        const auto metadata = *message;
        const int stamp = stampOf(metadata);
        if (stamp >= end && end > start)
            break;
        if (std::exchange(newest, stamp) != stamp) {
            firstOfSample = message;
            eventsBefore = eventCount;
        }
        const bool isExclusive = isSystemExclusive(metadata);
        const bool isEvent = isChannelMessage(metadata);
        const bool beginsPiece = stamp > start
                                     ? isExclusive || isAllSoundOff(metadata)
                                     : isExclusive && (eventCount > 0 || !systemExclusive.empty());
        if (beginsPiece || (isEvent && eventCount == events.size())) {
            end = stamp;
            if (stamp > start) { // all messages of that sample go into the next piece
                message = firstOfSample;
                eventCount = eventsBefore;
            }
            break;
        }
        if (isExclusive)
            systemExclusive = {metadata.data, static_cast<std::size_t>(metadata.numBytes)};
        if (!isEvent)
            continue;
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
