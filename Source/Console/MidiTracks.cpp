#include "Console/MidiTracks.h"

#include <cstdint>

namespace idiophone {
namespace {

/// The unread bytes. If too few are left, take() takes nothing.
struct Rest {
    std::string_view bytes;

    std::optional<std::string_view> take(std::size_t count) {
        if (bytes.size() < count)
            return std::nullopt;
        const auto taken = bytes.substr(0, count);
        bytes.remove_prefix(count);
        return taken;
    }
    std::optional<std::uint32_t> takeLong() {
        const auto taken = take(4);
        return taken ? std::optional(juce::ByteOrder::bigEndianInt(taken->data())) : std::nullopt;
    }
    std::optional<std::uint16_t> takeShort() {
        const auto taken = take(2);
        return taken ? std::optional(juce::ByteOrder::bigEndianShort(taken->data())) : std::nullopt;
    }
};

/// Skips to the end of the header's mark. Some files have a RIFF header before it.
bool skipToHeader(Rest& rest) {
    auto mark = rest.take(4);
    if (mark == "RIFF")
        for (int word = 0; word < 8 && mark && mark != "MThd"; ++word)
            mark = rest.take(4);
    return mark == "MThd";
}

std::vector<juce::MidiMessage> readTrack(std::string_view bytes) {
    std::vector<juce::MidiMessage> messages;
    const auto* data = reinterpret_cast<const juce::uint8*>(bytes.data());
    int size = static_cast<int>(bytes.size());
    double ticks = 0;
    juce::uint8 lastStatus = 0;
    while (size > 0) {
        const auto delay = juce::MidiMessage::readVariableLengthValue(data, size);
        data += delay.bytesUsed;
        size -= delay.bytesUsed;
        if (!delay.isValid() || size <= 0)
            break;
        ticks += delay.value;
        int used = 0;
        juce::MidiMessage message(data, size, used, lastStatus, ticks);
        if (used <= 0)
            break;
        data += used;
        size -= used;
        const auto status = *message.getRawData();
        if ((status & 0xf0) != 0xf0)
            lastStatus = status;
        messages.push_back(std::move(message));
    }
    return messages;
}

} // namespace

std::optional<MidiTracks> readMidiTracks(std::string_view bytes) {
    Rest rest{bytes};
    if (!skipToHeader(rest))
        return std::nullopt;
    const auto length = rest.takeLong();
    if (!length || *length > rest.bytes.size())
        return std::nullopt;
    const auto kind = rest.takeShort(), count = rest.takeShort(), format = rest.takeShort();
    if (!kind || !count || !format || *kind > 2 || (*kind == 0 && *count != 1))
        return std::nullopt;
    MidiTracks midi{.timeFormat = static_cast<short>(*format), .tracks = {}};
    // Chunks of other kinds are ignored. Some programs count them as tracks.
    for (int chunks = 0; midi.tracks.size() < *count; ++chunks) {
        if (chunks >= *count && rest.bytes.empty())
            break;
        const auto mark = rest.take(4);
        const auto size = rest.takeLong();
        const auto chunk = size ? rest.take(*size) : std::nullopt;
        if (!chunk)
            return std::nullopt;
        if (*mark == "MTrk")
            midi.tracks.push_back(readTrack(*chunk));
    }
    return midi;
}

} // namespace idiophone
