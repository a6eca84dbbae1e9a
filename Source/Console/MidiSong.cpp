#include "Console/MidiSong.h"

#include "Console/MidiTracks.h"
#include "Console/TempoMap.h"
#include "Instrument/MidiTuning.h"
#include "Object/FileBytes.h"
#include "Object/TextFile.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <ranges>
#include <span>
#include <utility>

namespace idiophone {
namespace {

constexpr double longestSeconds = 36000;

// Controllers precede the notes that start with them. Pressure follows, because it needs a key that
// is down.
int orderAtOneTime(const SongEvent& event) {
    if (event.isNoteOff())
        return 1;
    if (event.isNoteOn())
        return 2;
    return event.isPressure() ? 3 : 0;
}

/// Refuses formats with a zero part, because JUCE divides by it.
bool isUsableTimeFormat(short format) {
    return format < 0 ? (format & 0xff) != 0 : format != 0;
}

/// Orders the notes of one key of a track. At equal times some files put note-ons before note-offs.
/// Here a note-off comes first if it ends a sounding note, or if a later note-off ends the new
/// note.
void orderKey(std::span<SongEvent* const> notes) {
    std::ptrdiff_t down = 0;
    std::ptrdiff_t endsBehind = 0; // surplus of note-offs over note-ons that follow
    for (const auto* note : notes)
        endsBehind += note->isNoteOff() ? 1 : -1;
    for (auto rest = notes; !rest.empty();) {
        const auto isLater = [&](const SongEvent* note) {
            return note->seconds != rest.front()->seconds;
        };
        const auto later = std::find_if(rest.begin() + 1, rest.end(), isLater);
        const auto now = rest.first(static_cast<std::size_t>(later - rest.begin()));
        rest = rest.subspan(now.size());
        std::vector<SongEvent> begin, end;
        for (const auto* note : now)
            (note->isNoteOff() ? end : begin).push_back(*note);
        endsBehind -= std::ssize(end) - std::ssize(begin);
        if (endsBehind > 0)
            down = std::max(down, std::ssize(end));
        auto nextBegin = begin.begin(), nextEnd = end.begin();
        for (auto* note : now) {
            const bool isEnd = nextBegin == begin.end() || (nextEnd != end.end() && down > 0);
            *note = isEnd ? *nextEnd++ : *nextBegin++;
            down = isEnd ? std::max<std::ptrdiff_t>(down - 1, 0) : down + 1;
        }
    }
}

std::vector<SongEvent> channelMessages(const MidiTracks& midi) {
    struct Ranked {
        SongEvent event;
        int order = 0; ///< rank among events at its time; never decreases within a track
    };
    const TempoMap tempo(midi);
    std::vector<Ranked> all;
    for (const auto& track : midi.tracks) {
        const auto first = static_cast<std::ptrdiff_t>(all.size());
        for (const auto& message : track) {
            const int size = message.getRawDataSize();
            if (message.getChannel() == 0 || size < 2 || size > 3)
                continue;
            SongEvent event{.seconds = tempo.secondsAt(message.getTimeStamp())};
            std::copy_n(message.getRawData(), size, event.bytes.begin());
            all.push_back({event});
        }
        const auto ofTrack = std::ranges::subrange(all.begin() + first, all.end());
        std::ranges::stable_sort(ofTrack, {}, [](const Ranked& each) {
            return std::pair(each.event.seconds, each.event.isPressure());
        });
        std::map<std::pair<int, int>, std::vector<SongEvent*>> notes; // by channel and key
        for (auto& [event, order] : ofTrack)
            if (event.isNoteOn() || event.isNoteOff())
                notes[{event.bytes[0] & 0x0f, event.bytes[1]}].push_back(&event);
        for (const auto& [key, notesOfKey] : notes)
            orderKey(notesOfKey);
        for (std::size_t k = 0; k < ofTrack.size(); ++k) {
            auto& [event, order] = ofTrack[k];
            order = orderAtOneTime(event);
            if (k > 0 && event.seconds == ofTrack[k - 1].event.seconds)
                order = std::max(order, ofTrack[k - 1].order);
        }
    }
    std::ranges::stable_sort(
        all, {}, [](const Ranked& each) { return std::pair(each.event.seconds, each.order); });
    std::vector<SongEvent> events;
    std::ranges::transform(all, std::back_inserter(events), &Ranked::event);
    return events;
}

std::vector<SongTuning> tuningMessages(const MidiTracks& midi) {
    const TempoMap tempo(midi);
    std::vector<SongTuning> tunings;
    for (const auto& track : midi.tracks)
        for (const auto& message : track) {
            const std::span bytes(message.getRawData(),
                                  static_cast<std::size_t>(message.getRawDataSize()));
            if (message.isSysEx() && MidiTuning::isFor(bytes))
                tunings.push_back({.seconds = tempo.secondsAt(message.getTimeStamp()),
                                   .message = {bytes.begin(), bytes.end()}});
        }
    std::ranges::stable_sort(tunings, {}, &SongTuning::seconds);
    return tunings;
}

/// Returns whether the data bytes have seven bits. JUCE accepts any.
bool isWhole(const SongEvent& event) {
    return event.bytes[1] < 0x80 && event.bytes[2] < 0x80;
}

} // namespace

Result<MidiSong> readMidiSong(const std::filesystem::path& file) {
    return readTextFile(file).and_then(
        [&](const std::string& bytes) { return parseMidiSong(bytes, nameOf(file)); });
}

Result<MidiSong> parseMidiSong(std::string_view bytes, const std::string& name) {
    const auto refuse = [&](const std::string& fault) { return failure(name + ": " + fault); };
    const auto midi = readMidiTracks(bytes);
    if (!midi)
        return refuse(midi.error().message);
    if (!isUsableTimeFormat(midi->timeFormat))
        return refuse("the MIDI file is damaged: its beats have no ticks");
    MidiSong song{
        .events = channelMessages(*midi), .tunings = tuningMessages(*midi), .warnings = {}};
    for (const auto& oddity : midi->oddities)
        song.warnings.push_back(name + ": " + oddity);
    if (!std::ranges::all_of(song.events, isWhole))
        return refuse("the MIDI file is damaged: a message has a byte above 127");
    if (std::ranges::none_of(song.events, &SongEvent::isNoteOn))
        return refuse("it holds no notes");
    // The negation also catches NaN, which sorting may have put anywhere.
    const auto isInTime = [](const SongEvent& event) {
        return event.seconds >= 0 && event.seconds <= longestSeconds;
    };
    if (!std::ranges::all_of(song.events, isInTime))
        return refuse("it goes on for more than 10 hours");
    return song;
}

} // namespace idiophone
