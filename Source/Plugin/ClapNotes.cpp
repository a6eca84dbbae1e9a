#include "Plugin/ClapNotes.h"

#include "Instrument/MidiControllers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

constexpr int firstMember = 1, lastMember = 15; // of the zone that the parameter "MPE" gives
constexpr int placeAtRest = 64;
constexpr std::size_t reservedBytes = 65536; // some 7000 events
constexpr std::size_t reservedEnds = 4096;

int sevenBits(double share) {
    return share > 0 ? static_cast<int>(std::lround(127 * std::min(share, 1.0))) : 0;
}

} // namespace

ClapNotes::ClapNotes() {
    added.ensureSize(reservedBytes);
    merged.ensureSize(reservedBytes);
    ends.reserve(reservedEnds);
}

bool ClapNotes::handles(std::uint16_t type) noexcept {
    return type == CLAP_EVENT_NOTE_ON || type == CLAP_EVENT_NOTE_OFF ||
           type == CLAP_EVENT_NOTE_CHOKE || type == CLAP_EVENT_NOTE_EXPRESSION;
}

std::optional<int>
ClapNotes::follow(const clap_event_header& event, int sampleOffset, const Mpe& mpe) {
    sample = static_cast<int>(event.time) - sampleOffset;
    const auto& note = reinterpret_cast<const clap_event_note&>(event);
    if (event.type == CLAP_EVENT_NOTE_ON)
        return begin(note, mpe);
    if (event.type == CLAP_EVENT_NOTE_EXPRESSION)
        express(reinterpret_cast<const clap_event_note_expression&>(event), mpe);
    else
        end(note, event.type == CLAP_EVENT_NOTE_CHOKE ? 1 : note.velocity);
    return std::nullopt;
}

juce::MidiBuffer& ClapNotes::takeWith(const juce::MidiBuffer& others) {
    merged.clear();
    merged.addEvents(others, 0, -1, 0);
    merged.addEvents(added, 0, -1, 0);
    added.clear();
    return merged;
}

bool ClapNotes::isNewest(std::size_t index) const noexcept {
    return std::ranges::count(known().subspan(index + 1), notes[index].key, &Note::key) == 0;
}

/// Does not tell the host if another note has the same address, because that one goes on.
void ClapNotes::forget(std::size_t index, int atSample) {
    const Note note = notes[index];
    std::shift_left(known().begin() + static_cast<std::ptrdiff_t>(index), known().end(), 1);
    --noteCount;
    const bool isShared = std::ranges::any_of(known(), [&](const Note& other) {
        return other.channel == note.channel && other.key == note.key &&
               (other.id < 0 || note.id < 0 || other.id == note.id);
    });
    if (!isShared)
        ends.push_back({.header = {.size = sizeof(clap_event_note),
                                   .time = static_cast<std::uint32_t>(std::max(atSample, 0)),
                                   .space_id = CLAP_CORE_EVENT_SPACE_ID,
                                   .type = CLAP_EVENT_NOTE_END,
                                   .flags = 0},
                        .note_id = note.id,
                        .port_index = 0,
                        .channel = note.channel,
                        .key = note.key,
                        .velocity = 0});
}

/// Forgets the oldest released note, or else the oldest one.
void ClapNotes::makeRoom() {
    if (noteCount < notes.size())
        return;
    const auto released = std::ranges::find(known(), false, &Note::isHeld);
    const auto oldest = released != known().end() ? released : known().begin();
    if (oldest->isHeld)
        release(*oldest, 0);
    forget(static_cast<std::size_t>(oldest - known().begin()), sample);
}

void ClapNotes::sendEnds(const clap_output_events& events, int sampleOffset) {
    for (auto& end : ends) {
        end.header.time += static_cast<std::uint32_t>(sampleOffset);
        events.try_push(&events, &end.header);
    }
    ends.clear();
}

bool ClapNotes::has(int key) const noexcept {
    return std::ranges::count(known(), key, &Note::key) > 0;
}

void ClapNotes::reset() noexcept {
    noteCount = 0;
    added.clear();
    ends.clear();
}

int ClapNotes::usersOf(int midiChannel) noexcept {
    return static_cast<int>(std::ranges::count_if(
        known(), [&](const Note& note) { return note.isHeld && note.midiChannel == midiChannel; }));
}

/// Among the channels with the fewest notes, the one used longest ago, whose last note has rung
/// longest.
int ClapNotes::freestMember() noexcept {
    int freest = firstMember;
    for (int member = firstMember; member <= lastMember; ++member) {
        const auto rank = [this](int channel) {
            return std::pair(usersOf(channel), lastUse[static_cast<std::size_t>(channel)]);
        };
        if (rank(member) < rank(freest))
            freest = member;
    }
    return freest;
}

std::optional<int> ClapNotes::begin(const clap_event_note& event, const Mpe& mpe) {
    if (event.key < 0 || event.key > 127 || event.channel < 0 || event.channel > 15)
        return std::nullopt;
    makeRoom();
    const int midiChannel = mpe.isOn ? freestMember() : event.channel;
    if (mpe.isOn && usersOf(midiChannel) == 0) {
        bend(midiChannel, 0);
        add(0xb0, midiChannel, midi::place, placeAtRest);
    }
    notes[noteCount++] = {.id = event.note_id,
                          .channel = event.channel,
                          .key = event.key,
                          .midiChannel = midiChannel,
                          .ownsChannel = mpe.isOn};
    lastUse[static_cast<std::size_t>(midiChannel)] = ++uses;
    add(0x90, midiChannel, event.key, std::max(1, sevenBits(event.velocity)));
    endReleased([&](const Note& note) { return note.key == event.key; }, sample);
    return event.key;
}

void ClapNotes::end(const clap_event_note& event, double velocity) {
    for (Note& note : known())
        if (note.isHeld && isAddressed(note, event))
            release(note, velocity);
}

void ClapNotes::release(Note& note, double velocity) {
    note.isHeld = false;
    lastUse[static_cast<std::size_t>(note.midiChannel)] = ++uses;
    add(0x80, note.midiChannel, note.key, sevenBits(velocity));
}

void ClapNotes::express(const clap_event_note_expression& event, const Mpe& mpe) {
    for (const Note& note : known()) {
        if (!note.isHeld || !isAddressed(note, event))
            continue;
        if (event.expression_id == CLAP_NOTE_EXPRESSION_PRESSURE)
            add(0xa0, note.midiChannel, note.key, sevenBits(event.value));
        else if (note.ownsChannel && event.expression_id == CLAP_NOTE_EXPRESSION_TUNING)
            bend(note.midiChannel, event.value / mpe.bendRangeSemitones);
        else if (note.ownsChannel && event.expression_id == CLAP_NOTE_EXPRESSION_BRIGHTNESS)
            add(0xb0, note.midiChannel, midi::place, sevenBits(event.value));
    }
}

/// `share` is the part of the bend range, -1 to 1.
void ClapNotes::bend(int midiChannel, double share) {
    const double bounded = std::isfinite(share) ? std::clamp(share, -1.0, 1.0) : 0;
    const int position = 8192 + static_cast<int>(std::lround(8191 * bounded));
    add(0xe0, midiChannel, position % 128, position / 128);
}

void ClapNotes::add(int kind, int midiChannel, int first, int second) {
    const std::array bytes{static_cast<juce::uint8>(kind | midiChannel),
                           static_cast<juce::uint8>(first), static_cast<juce::uint8>(second)};
    added.addEvent(bytes.data(), static_cast<int>(bytes.size()), sample);
}

} // namespace idiophone
