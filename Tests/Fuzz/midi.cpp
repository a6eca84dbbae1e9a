// Fuzzes Standard MIDI Files, as `idiophone render` plays them.
#include "Console/MidiSong.h"
#include "Console/TempoMap.h"
#include "Fuzz/FuzzTarget.h"
#include "Instrument/MidiTuning.h"

#include <algorithm>
#include <optional>

namespace idiophone::fuzz {
namespace {

/// Returns whether JUCE may read these bytes otherwise: it stops system exclusive messages at the
/// first status byte, and passes over tracks that the header does not count.
bool mayDifferFromJuce(std::string_view bytes, const MidiTracks& midi) {
    return bytes.find_first_of("\xf0\xf7") != std::string_view::npos || !midi.oddities.empty();
}

/// Returns nothing for large files, where JUCE takes long, and if JUCE finds no tracks. JUCE reads
/// 32768 or more tracks as a negative number.
std::optional<juce::MidiFile> readByJuce(std::string_view bytes) {
    if (bytes.size() > 1 << 14)
        return std::nullopt;
    juce::MemoryInputStream stream(bytes.data(), bytes.size(), false);
    juce::MidiFile midi;
    if (!midi.readFrom(stream, false) || midi.getNumTracks() == 0)
        return std::nullopt;
    return midi;
}

void claimTracksOfJuce(std::string_view bytes) {
    const auto juces = readByJuce(bytes);
    if (!juces)
        return;
    const auto midi = readMidiTracks(bytes);
    if (!midi || mayDifferFromJuce(bytes, *midi))
        return;
    claim(midi->timeFormat == juces->getTimeFormat() &&
              std::ssize(midi->tracks) == juces->getNumTracks(),
          "JUCE finds the same tracks");
    for (int track = 0; track < juces->getNumTracks(); ++track)
        claim(std::ssize(midi->tracks[static_cast<std::size_t>(track)]) ==
                  juces->getTrack(track)->getNumEvents(),
              "a track has the messages that JUCE finds");
}

/// Returns whether a tempo message is too short; JUCE reads past its end.
bool isHalfTempo(const juce::MidiMessage& message) {
    return message.isTempoMetaEvent() && !isTempo(message);
}

/// Claims the same times as JUCE, bit for bit.
void claimTimesOfJuce(std::string_view bytes) {
    auto juces = readByJuce(bytes);
    const auto midi = readMidiTracks(bytes);
    constexpr int droppedFrames = -29;
    if (!juces || !midi || mayDifferFromJuce(bytes, *midi) ||
        midi->timeFormat >> 8 == droppedFrames ||
        std::ranges::any_of(midi->tracks, [](const auto& track) {
            return std::ranges::any_of(track, isHalfTempo);
        }))
        return;
    const TempoMap tempo(*midi);
    juces->convertTimestampTicksToSeconds();
    for (int track = 0; track < juces->getNumTracks(); ++track) {
        const auto& messages = midi->tracks[static_cast<std::size_t>(track)];
        for (std::size_t k = 0; k < messages.size(); ++k)
            claim(tempo.secondsAt(messages[k].getTimeStamp()) ==
                      juces->getTrack(track)->getEventTime(static_cast<int>(k)),
                  "times are those of JUCE");
    }
}

} // namespace

void examine(std::string_view bytes) {
    claimTracksOfJuce(bytes);
    const auto song = readMidiSong(scratchFile(bytes, "fuzz.mid"));
    if (!song)
        return claimSentence(song.error());
    claimTimesOfJuce(bytes);
    claim(std::ranges::any_of(song->events, &SongEvent::isNoteOn), "a song has notes");
    claim(std::ranges::is_sorted(song->events, {}, &SongEvent::seconds),
          "events are in order of time");
    claim(std::ranges::is_sorted(song->tunings, {}, &SongTuning::seconds),
          "tunings are in order of time");
    for (const auto& tuning : song->tunings)
        claim(MidiTuning().read(tuning.message), "a tuning tunes");
    for (const auto& event : song->events) {
        claim(event.seconds >= 0 && event.seconds <= 36000, "a song lasts 10 hours at most");
        claim(event.bytes[0] >= 0x80 && event.bytes[0] < 0xf0, "events are channel messages");
        claim(event.bytes[1] < 0x80 && event.bytes[2] < 0x80, "data bytes have seven bits");
    }
}

} // namespace idiophone::fuzz
