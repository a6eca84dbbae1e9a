#include "Plugin/InstrumentSession.h"

#include "Instrument/OwnSlots.h"
#include "Instrument/StruckPlaces.h"

#include <algorithm>
#include <juce_core/juce_core.h>
#include <utility>

namespace idiophone {
namespace {

constexpr const char* pauseSentence =
    "Strikes in the window are silent: the host has paused, or no audio device is open.";

} // namespace

InstrumentView::KeyRange InstrumentSession::keyRange() const {
    const auto held = session.lock();
    const auto& map = session.playing().preset.keyMap;
    return {.lowest = map.lowestNote, .highest = map.highestNote};
}

std::array<InstrumentView::KeySound, 128> InstrumentSession::keySounds() const {
    std::array<KeySound, 128> sounds{};
    if (const auto playing = session.instrument())
        for (int note = 0; note < 128; ++note)
            if (playing->key(note).slot >= 0)
                sounds[static_cast<std::size_t>(note)] =
                    playing->hasOwn(note) ? KeySound::own : KeySound::resized;
    return sounds;
}

std::vector<InstrumentView::PlayedObject> InstrumentSession::playedObjects() const {
    std::vector<PlayedObject> objects;
    const auto playing = session.instrument();
    if (playing == nullptr)
        return objects;
    const auto slots = playing->slots();
    for (const auto own : ownSlots(*playing)) {
        PlayedObject played{.object = slots[own].object,
                            .sizeRatio = slots[own].sizeRatio,
                            .lowestNote = 127,
                            .highestNote = 0};
        for (int note = 0; note < 128; ++note)
            for (const Key& key : playing->keysOf(note))
                if (key.slot >= 0 && key.isOwn &&
                    slots[static_cast<std::size_t>(key.slot)].object == played.object) {
                    played.lowestNote = std::min(played.lowestNote, note);
                    played.highestNote = std::max(played.highestNote, note);
                }
        objects.push_back(std::move(played));
    }
    return objects;
}

std::vector<std::array<double, 3>> InstrumentSession::struckPlaces(std::size_t index) const {
    const auto playing = session.instrument();
    if (playing == nullptr)
        return {};
    const auto slots = ownSlots(*playing);
    return index < slots.size() ? idiophone::struckPlaces(*playing, slots[index])
                                : std::vector<std::array<double, 3>>();
}

void InstrumentSession::playNote(int midiNote, int velocity) {
    if (velocity <= 0 || takesStrikes())
        events.pushNote(midiNote, velocity);
}

void InstrumentSession::strikeObject(std::size_t index,
                                     const std::array<double, 3>& pointMetres,
                                     int velocity) {
    const auto playing = session.instrument();
    if (playing == nullptr || (velocity > 0 && !takesStrikes()))
        return;
    if (const auto slots = ownSlots(*playing); index < slots.size())
        hand.strike(playing, slots[index], pointMetres, velocity);
}

void InstrumentSession::scrapeObject(std::size_t index,
                                     const std::array<double, 3>& pointMetres,
                                     double pressure) {
    const auto playing = session.instrument();
    if (playing == nullptr || (pressure > 0 && !takesStrikes()))
        return;
    if (const auto slots = ownSlots(*playing); index < slots.size())
        hand.scrape(playing, slots[index], pointMetres, pressure);
}

bool InstrumentSession::isProcessing() const {
    // Twice the length of 8192 samples at 44.1 kHz.
    constexpr std::uint32_t longestPauseMilliseconds = 400;
    return report.callbacks != callbacksSeen ||
           juce::Time::getMillisecondCounter() - lastCallbackMilliseconds <
               longestPauseMilliseconds;
}

bool InstrumentSession::takesStrikes() {
    if (isProcessing())
        return true;
    hasRefused = true;
    session.reportError(pauseSentence);
    return false;
}

void InstrumentSession::poll() {
    if (const auto count = report.callbacks.load(); std::exchange(callbacksSeen, count) == count)
        return;
    lastCallbackMilliseconds = juce::Time::getMillisecondCounter();
    if (std::exchange(hasRefused, false))
        session.takeBackError(pauseSentence);
}

} // namespace idiophone
