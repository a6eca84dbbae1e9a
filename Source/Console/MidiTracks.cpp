#include "Console/MidiTracks.h"

#include "Console/TrackReader.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>

namespace idiophone {
namespace {

constexpr std::size_t chunkHeaderBytes = 8;

std::uint32_t longAt(std::string_view bytes, std::size_t place) {
    return juce::ByteOrder::bigEndianInt(bytes.data() + place);
}

std::uint16_t shortAt(std::string_view bytes, std::size_t place) {
    return juce::ByteOrder::bigEndianShort(bytes.data() + place);
}

/// Returns the bytes from the file's header on; empty if there is none. Adds a sentence if other
/// bytes precede it that belong to no RIFF file.
std::string_view fromHeader(std::string_view bytes, std::vector<std::string>& oddities) {
    constexpr std::size_t mostBytesBefore = 4096; // MacBinary has 128
    const bool isRiff =
        bytes.size() >= 12 && bytes.starts_with("RIFF") && bytes.substr(8, 4) == "RMID";
    const auto start = (isRiff ? bytes : bytes.substr(0, mostBytesBefore)).find("MThd");
    if (start == std::string_view::npos)
        return {};
    auto content = bytes.substr(start);
    if (start >= chunkHeaderBytes && bytes.substr(start - chunkHeaderBytes).starts_with("data"))
        content = content.substr(0, juce::ByteOrder::littleEndianInt(bytes.data() + start - 4));
    if (!isRiff && start > 0)
        oddities.push_back("the " + std::to_string(start) +
                           " bytes before its header are left out");
    return content;
}

/// Returns whether these can be the bytes behind a chunk.
bool isChunkOrEnd(std::string_view bytes) {
    const auto isLetter = [](unsigned char letter) { return std::isprint(letter) != 0; };
    return bytes.empty() ||
           (bytes.size() >= 4 && std::ranges::all_of(bytes.substr(0, 4), isLetter));
}

/// Reads the track at the start of `rest` and removes its chunk. If its length is wrong, the track
/// goes on to its end event. Returns nothing if it has none.
std::optional<TrackContent>
takeTrack(std::string_view& rest, bool isLast, std::vector<std::string>& oddities, int number) {
    const std::size_t length = longAt(rest, 4);
    rest.remove_prefix(chunkHeaderBytes);
    const auto name = "track " + std::to_string(number);
    if (length <= rest.size()) {
        auto track = readTrack(rest.substr(0, length), ReadTo::endOfBytes);
        if (isChunkOrEnd(rest.substr(length)) || (isLast && track.hasEnd)) {
            if (track.isDamaged)
                oddities.push_back(name + " is damaged: its rest is left out");
            rest.remove_prefix(length);
            return track;
        }
    }
    auto track = readTrack(rest, ReadTo::endOfTrack);
    if (!track.hasEnd)
        return std::nullopt;
    if (track.bytes != length)
        oddities.push_back("the length of " + name + " is wrong: it is read to its end event");
    rest.remove_prefix(track.bytes);
    return track;
}

void addOdditiesOf(int kind, std::size_t counted, MidiTracks& midi) {
    const auto found = std::to_string(midi.tracks.size());
    if (kind == 0 && midi.tracks.size() > 1)
        midi.oddities.push_back("it is of type 0, which has one track, but it has " + found +
                                ": all are played");
    else if (midi.tracks.size() > counted)
        midi.oddities.push_back("its header counts " + std::to_string(counted) +
                                (counted == 1 ? " track" : " tracks") + ", but it has " + found +
                                ": all are played");
    if (kind == 2 && midi.tracks.size() > 1)
        midi.oddities.push_back("it is of type 2, whose tracks are separate songs: all are played "
                                "at once");
}

} // namespace

Result<MidiTracks> readMidiTracks(std::string_view bytes) {
    MidiTracks midi;
    auto rest = fromHeader(bytes, midi.oddities);
    if (rest.empty())
        return failure("it is not a MIDI file");
    if (rest.size() < chunkHeaderBytes + 6)
        return failure("the MIDI file is cut off in its header");
    const int kind = shortAt(rest, 8);
    const std::size_t counted = shortAt(rest, 10);
    midi.timeFormat = static_cast<short>(shortAt(rest, 12));
    if (kind > 2)
        return failure("the MIDI file is damaged: there is no type " + std::to_string(kind));
    const auto headerBytes = std::max<std::size_t>(longAt(rest, 4), 6) + chunkHeaderBytes;
    if (headerBytes > rest.size())
        return failure("the MIDI file is cut off in its header");
    rest.remove_prefix(headerBytes);
    const auto takeBlanks = [&] { // some programs fill up chunks
        rest.remove_prefix(std::min(rest.find_first_not_of('\0'), rest.size()));
    };
    // Chunks of other kinds are ignored. Some programs count them as tracks.
    std::size_t chunks = 0;
    for (takeBlanks(); midi.tracks.size() < counted || rest.starts_with("MTrk"); takeBlanks()) {
        if (chunks++ >= counted && rest.empty())
            break;
        const auto number = static_cast<int>(midi.tracks.size()) + 1;
        const auto refuse = [&] {
            return failure("the MIDI file is damaged or cut off in track " +
                           std::to_string(number) + " of " + std::to_string(counted));
        };
        if (rest.size() < chunkHeaderBytes)
            return refuse();
        if (!rest.starts_with("MTrk")) {
            const auto size = longAt(rest, 4);
            if (size > rest.size() - chunkHeaderBytes)
                return refuse();
            rest.remove_prefix(chunkHeaderBytes + size);
            continue;
        }
        auto track = takeTrack(rest, midi.tracks.size() + 1 >= counted, midi.oddities, number);
        if (!track)
            return refuse();
        midi.tracks.push_back(std::move(track->messages));
    }
    addOdditiesOf(kind, counted, midi);
    return midi;
}

} // namespace idiophone
