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

int sevenBits(double share) {
    return share > 0 ? static_cast<int>(std::lround(127 * std::min(share, 1.0))) : 0;
}

/// A host may leave any of these open with -1.
template <class Event>
auto addressedBy(const Event& event) {
    return [&event](const auto& note) {
        return (event.note_id < 0 || event.note_id == note.id) &&
               (event.channel < 0 || event.channel == note.channel) &&
               (event.key < 0 || event.key == note.key);
    };
}

} // namespace

ClapNotes::ClapNotes() {
    added.ensureSize(reservedBytes);
    merged.ensureSize(reservedBytes);
}

bool ClapNotes::handles(std::uint16_t type) noexcept {
    return type == CLAP_EVENT_NOTE_ON || type == CLAP_EVENT_NOTE_OFF ||
           type == CLAP_EVENT_NOTE_CHOKE || type == CLAP_EVENT_NOTE_EXPRESSION;
}

void ClapNotes::follow(const clap_event_header& event, int sampleOffset, const Mpe& mpe) {
    sample = static_cast<int>(event.time) - sampleOffset;
    if (event.type == CLAP_EVENT_NOTE_EXPRESSION)
        return express(reinterpret_cast<const clap_event_note_expression&>(event), mpe);
    const auto& note = reinterpret_cast<const clap_event_note&>(event);
    if (event.type == CLAP_EVENT_NOTE_ON)
        begin(note, mpe);
    else
        end(note, event.type == CLAP_EVENT_NOTE_CHOKE ? 1 : note.velocity);
}

juce::MidiBuffer& ClapNotes::takeWith(const juce::MidiBuffer& others) {
    merged.clear();
    merged.addEvents(others, 0, -1, 0);
    merged.addEvents(added, 0, -1, 0);
    added.clear();
    return merged;
}

void ClapNotes::reset() noexcept {
    noteCount = 0;
    added.clear();
}

int ClapNotes::usersOf(int midiChannel) noexcept {
    return static_cast<int>(std::ranges::count(held(), midiChannel, &Note::midiChannel));
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

void ClapNotes::begin(const clap_event_note& event, const Mpe& mpe) {
    if (event.key < 0 || event.key > 127 || event.channel < 0 || event.channel > 15)
        return;
    if (noteCount == notes.size()) { // the host never ended the oldest
        std::shift_left(notes.begin(), notes.end(), 1);
        --noteCount;
    }
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
}

void ClapNotes::end(const clap_event_note& event, double velocity) {
    const auto isEnded = addressedBy(event);
    for (const Note& note : held()) {
        if (!isEnded(note))
            continue;
        lastUse[static_cast<std::size_t>(note.midiChannel)] = ++uses;
        add(0x80, note.midiChannel, note.key, sevenBits(velocity));
    }
    noteCount -= std::ranges::remove_if(held(), isEnded).size();
}

void ClapNotes::express(const clap_event_note_expression& event, const Mpe& mpe) {
    for (const Note& note : held()) {
        if (!addressedBy(event)(note))
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
