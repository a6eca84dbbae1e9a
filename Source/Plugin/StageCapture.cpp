#include "Plugin/StageCapture.h"

#include "Editor/Utf8.h"
#include "Instrument/ImpulseLine.h"
#include "Instrument/OwnSlots.h"
#include "Plugin/WholeFile.h"

#include <algorithm>
#include <cmath>
#include <juce_audio_basics/juce_audio_basics.h>
#include <utility>

namespace idiophone {
namespace {

constexpr int ticksPerBeat = 960;
constexpr double noteSeconds = 0.05;
constexpr int firstObjectNote = 36;
constexpr double usualVelocityCurve = 1.5; // default of the parameter

double newtonSecondsOf(const PlacedImpact& impact) {
    const auto& impulse = impact.strike.impulseNewtonSeconds;
    return std::hypot(double(impulse[0]), double(impulse[1]), double(impulse[2]));
}

/// Returns the note of each slot, or −1 if none is left.
std::vector<int> notesOf(const Instrument& instrument) {
    const auto slots = instrument.slots();
    std::vector<int> notes(slots.size(), -1);
    if (instrument.keysHaveObjects())
        for (int note = 127; note >= 0; --note)
            for (const Key& key : instrument.keysOf(note))
                if (key.slot >= 0)
                    notes[static_cast<std::size_t>(key.slot)] = note;
    int next = firstObjectNote;
    for (const auto own : ownSlots(instrument)) {
        if (notes[own] >= 0)
            continue;
        while (instrument.keysHaveObjects() && next < 128 && instrument.key(next).slot >= 0)
            ++next; // skips the notes of keys
        for (std::size_t slot = 0; slot < slots.size(); ++slot)
            if (slots[slot].object == slots[own].object && next < 128)
                notes[slot] = next;
        ++next;
    }
    return notes;
}

} // namespace

void StageCapture::take(Player& player) noexcept {
    for (const auto& impact : player.stage().takeImpacts())
        messages.push({.instrument = player.instrument().serialNumber(),
                       .performance = player.stage().number(),
                       .impact = impact});
}

/// Returns the impacts by time, counted from the first. Impacts of one cell arrive in the order of
/// their simulations.
std::vector<PlacedImpact> StageCapture::inOrder() const {
    auto impacts = kept;
    std::ranges::stable_sort(impacts, {}, &PlacedImpact::seconds);
    if (!impacts.empty())
        for (const double first = impacts.front().seconds; auto& impact : impacts)
            impact.seconds -= first;
    return impacts;
}

void StageCapture::follow(const std::shared_ptr<const Instrument>& instrument) {
    if (instrument != played) {
        played = instrument;
        clear();
    }
    messages.consume_all([this](const Message& message) {
        if (played == nullptr || message.instrument != played->serialNumber())
            return;
        if (std::exchange(performance, message.performance) != message.performance)
            clear();
        if (kept.size() < maximumImpacts)
            kept.push_back(message.impact);
    });
}

Result<void> StageCapture::writeMidi(const std::filesystem::path& file,
                                     double beatsPerMinute) const {
    if (kept.empty())
        return failure("nothing has been struck yet");
    const auto notes = notesOf(*played);
    double hardest = 0;
    for (const auto& impact : kept)
        hardest = std::max(hardest, newtonSecondsOf(impact));
    juce::MidiMessageSequence track;
    track.addEvent(juce::MidiMessage::tempoMetaEvent(juce::roundToInt(6e7 / beatsPerMinute)));
    const auto ticks = [&](double seconds) {
        return std::round(seconds * beatsPerMinute / 60 * ticksPerBeat);
    };
    for (const auto& impact : inOrder()) {
        const int note = notes[impact.slot];
        if (note < 0)
            continue;
        const double share = hardest > 0 ? newtonSecondsOf(impact) / hardest : 1;
        const int velocity =
            juce::jlimit(1, 127, juce::roundToInt(127 * std::pow(share, 1 / usualVelocityCurve)));
        track.addEvent(juce::MidiMessage::noteOn(1, note, static_cast<juce::uint8>(velocity)),
                       ticks(impact.seconds));
        track.addEvent(juce::MidiMessage::noteOff(1, note), ticks(impact.seconds + noteSeconds));
    }
    track.updateMatchedPairs();
    juce::MidiFile midi;
    midi.setTicksPerQuarterNote(ticksPerBeat);
    midi.addTrack(track);
    juce::MemoryOutputStream bytes;
    midi.writeTo(bytes);
    return writeWhole(fileOf(file),
                      {static_cast<const std::byte*>(bytes.getData()), bytes.getDataSize()});
}

Result<void> StageCapture::writeImpulses(const std::filesystem::path& file) const {
    if (kept.empty())
        return failure("nothing has been struck yet");
    std::vector<std::string> objects;
    for (std::size_t slot = 0; slot < played->slots().size(); ++slot) {
        const auto& name = played->stage()->objectOf(slot);
        if (name.empty())
            return failure(namelessObjects);
        objects.push_back(objectInList(name, file));
    }
    std::string lines;
    for (const auto& impact : inOrder())
        lines += impulseLine(objects[impact.slot], played->slots()[impact.slot].sizeRatio, impact);
    return writeWhole(fileOf(file), std::as_bytes(std::span(lines)));
}

} // namespace idiophone
