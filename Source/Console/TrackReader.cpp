#include "Console/TrackReader.h"

#include <optional>
#include <string>

namespace idiophone {
namespace {

class TrackReader {
public:
    explicit TrackReader(std::string_view bytes) : rest(bytes) {}

    bool isAtEnd() const { return rest.empty(); }
    std::size_t bytesLeft() const { return rest.size(); }

    /// Reads an event and adds its message, if it is one. Returns false if none can be read.
    bool readEvent(std::vector<juce::MidiMessage>& messages) {
        const auto delay = takeNumber();
        if (!delay || rest.empty())
            return false;
        ticks += *delay;
        const auto status = static_cast<juce::uint8>(rest.front());
        if (status == 0xf0 || status == 0xf7)
            return readPacket(status, messages);
        int used = 0;
        juce::MidiMessage message(rest.data(), static_cast<int>(rest.size()), used, lastStatus,
                                  ticks);
        if (used <= 0 || static_cast<std::size_t>(used) > rest.size())
            return false;
        rest.remove_prefix(static_cast<std::size_t>(used));
        if (const auto first = *message.getRawData(); (first & 0xf0) != 0xf0)
            lastStatus = first;
        messages.push_back(std::move(message));
        return true;
    }

private:
    std::optional<int> takeNumber() {
        const auto number = juce::MidiMessage::readVariableLengthValue(
            reinterpret_cast<const juce::uint8*>(rest.data()), static_cast<int>(rest.size()));
        if (!number.isValid())
            return std::nullopt;
        rest.remove_prefix(static_cast<std::size_t>(number.bytesUsed));
        return number.value;
    }

    bool readPacket(juce::uint8 status, std::vector<juce::MidiMessage>& messages) {
        rest.remove_prefix(1);
        const auto size = takeNumber();
        if (!size || static_cast<std::size_t>(*size) > rest.size())
            return false;
        const auto packet = rest.substr(0, static_cast<std::size_t>(*size));
        rest.remove_prefix(packet.size());
        if (status == 0xf0)
            exclusive = packet;
        else if (!exclusive)
            return true; // an escape
        else
            exclusive->append(packet);
        // If no packet follows, the message is over too, without F7.
        const bool goesOn = !exclusive->ends_with('\xf7') && continuesNext();
        if (goesOn)
            return true;
        if (exclusive->ends_with('\xf7'))
            exclusive->pop_back();
        messages.push_back(juce::MidiMessage::createSysExMessage(
            exclusive->data(), static_cast<int>(exclusive->size())));
        messages.back().setTimeStamp(ticks);
        exclusive.reset();
        return true;
    }

    /// Returns whether the next event is an F7 packet.
    bool continuesNext() const {
        TrackReader ahead(rest);
        return ahead.takeNumber() && ahead.rest.starts_with('\xf7');
    }

    std::string_view rest;
    std::optional<std::string> exclusive; ///< the packets so far of a message
    double ticks = 0;
    juce::uint8 lastStatus = 0;
};

} // namespace

TrackContent readTrack(std::string_view bytes, ReadTo readTo) {
    TrackContent track;
    TrackReader reader(bytes);
    const auto isOver = [&] {
        return reader.isAtEnd() || (readTo == ReadTo::endOfTrack && track.hasEnd);
    };
    while (!isOver() && !track.isDamaged) {
        track.isDamaged = !reader.readEvent(track.messages);
        if (!track.messages.empty() && track.messages.back().isEndOfTrackMetaEvent())
            track.hasEnd = true;
    }
    track.bytes = bytes.size() - reader.bytesLeft();
    // Bytes behind the end event are no damage.
    track.isDamaged = track.isDamaged && !track.hasEnd;
    return track;
}

} // namespace idiophone
