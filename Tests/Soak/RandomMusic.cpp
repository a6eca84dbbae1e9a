#include "Soak/RandomMusic.h"

#include "Instrument/MidiControllers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace idiophone::test {
namespace {

constexpr int channels = 16;
constexpr int centredWheel = 8192;
constexpr double longNoteShare = 0.02; // share of notes that last up to a minute

void addSystemExclusive(juce::MidiBuffer& midi,
                        const std::vector<juce::uint8>& content,
                        int stamp) {
    midi.addEvent(
        juce::MidiMessage::createSysExMessage(content.data(), static_cast<int>(content.size())),
        stamp);
}

/// MIDI Tuning Standard: a bulk dump of equal temperament.
void addEqualTuning(juce::MidiBuffer& midi, int stamp) {
    std::vector<juce::uint8> content{0x7e, 0x7f, 0x08, 0x01, 0};
    content.resize(content.size() + 16, ' '); // name of the tuning
    for (juce::uint8 note = 0; note < 128; ++note)
        content.insert(content.end(), {note, 0, 0});
    const int sum = std::accumulate(content.begin(), content.end(), 0,
                                    [](int all, juce::uint8 byte) { return all ^ byte; });
    content.push_back(static_cast<juce::uint8>(sum & 0x7f));
    addSystemExclusive(midi, content, stamp);
}

void addController(juce::MidiBuffer& midi, int channel, int number, int value, int stamp = 0) {
    midi.addEvent(juce::MidiMessage::controllerEvent(channel, number, value), stamp);
}

} // namespace

void addDefaults(juce::MidiBuffer& midi) {
    addEqualTuning(midi, 0);
    for (const int manager : {1, channels}) {
        addController(midi, manager, midi::registeredMsb, 0);
        addController(midi, manager, midi::registeredLsb, 6);
        addController(midi, manager, midi::dataEntryMsb, 0);
    }
    for (int channel = 1; channel <= channels; ++channel) {
        addController(midi, channel, midi::registeredMsb, 0);
        addController(midi, channel, midi::registeredLsb, 0);
        addController(midi, channel, midi::dataEntryMsb, 2);
        addController(midi, channel, midi::modulation, 64);
        addController(midi, channel, midi::place, 64);
        addController(midi, channel, midi::softPedal, 0);
        midi.addEvent(juce::MidiMessage::pitchWheel(channel, centredWheel), 0);
    }
}

void addEndOfNotes(juce::MidiBuffer& midi) {
    for (int channel = 1; channel <= channels; ++channel)
        for (const int number : {midi::resetControllers, midi::allNotesOff})
            addController(midi, channel, number, 0);
}

void RandomMusic::add(juce::MidiBuffer& midi, const Block& block, double expectedNotes) {
    const int count = static_cast<int>(expectedNotes) +
                      (chance.share() < expectedNotes - std::floor(expectedNotes));
    std::vector<int> stamps(static_cast<std::size_t>(count));
    std::ranges::generate(stamps, [&] { return chance.below(block.length); });
    std::ranges::sort(stamps);
    for (const int stamp : stamps) {
        addDueReleases(midi, block, stamp);
        addNote(midi, block, chance.share() < 0.8 ? 1 : 1 + chance.below(channels), stamp);
    }
    addDueReleases(midi, block, block.length - 1);
}

void RandomMusic::slide(juce::MidiBuffer& midi, InstrumentView::KeyRange keys, std::int64_t end) {
    slides = true;
    const std::pair key{channels, keys.lowest + chance.below(keys.highest - keys.lowest + 1)};
    midi.addEvent(juce::MidiMessage::noteOn(key.first, key.second, juce::uint8{20}), 0);
    keysDown[key] = end;
}

void RandomMusic::addOwed(juce::MidiBuffer& midi) const {
    for (const auto& [key, end] : keysDown)
        midi.addEvent(juce::MidiMessage::noteOff(key.first, key.second), 0);
    for (const auto& [channel, pedals] : pedalsDown) {
        if (pedals.sustains)
            addController(midi, channel, midi::sustainPedal, 0);
        if (pedals.catches)
            addController(midi, channel, midi::sostenutoPedal, 0);
    }
}

void RandomMusic::forget() {
    keysDown.clear();
    pedalsDown.clear();
}

void RandomMusic::addNote(juce::MidiBuffer& midi, const Block& block, int channel, int stamp) {
    const int note = block.keys.lowest + chance.below(block.keys.highest - block.keys.lowest + 1);
    if (keysDown.contains({channel, note}))
        return; // at most one note per key and channel, as on a keyboard
    midi.addEvent(
        juce::MidiMessage::noteOn(channel, note, static_cast<juce::uint8>(1 + chance.below(127))),
        stamp);
    ++notes;
    const bool isLong = !slides && chance.share() < longNoteShare;
    const double seconds = (isLong ? 60 : 0.5) * chance.share();
    keysDown[{channel, note}] =
        block.start + stamp + 1 + static_cast<std::int64_t>(seconds * block.rateHz);
    addControllers(midi, channel, note, stamp);
}

void RandomMusic::addControllers(juce::MidiBuffer& midi, int channel, int note, int stamp) {
    switch (chance.below(8)) {
    case 0:
        midi.addEvent(juce::MidiMessage::pitchWheel(channel, chance.below(2 * centredWheel)),
                      stamp);
        break;
    case 1:
        midi.addEvent(juce::MidiMessage::channelPressureChange(channel, chance.below(128)), stamp);
        break;
    case 2:
        midi.addEvent(juce::MidiMessage::aftertouchChange(channel, note, chance.below(128)), stamp);
        break;
    case 3: {
        // The last two controllers end a slide on any channel.
        constexpr std::array controllers{1, 6, 38, 64, 66, 67, 74, 100, 101, 121, 120, 123};
        const int count = static_cast<int>(controllers.size()) - (slides ? 2 : 0);
        const int value = chance.below(128);
        const auto which = static_cast<std::size_t>(chance.below(count));
        control(midi, channel, controllers[which], value, stamp);
        break;
    }
    case 4:
        if (chance.share() < 0.1)
            addTuning(midi, stamp);
        break;
    default:
        break;
    }
}

/// Tunes keys, the wheel's range or MPE's zones.
void RandomMusic::addTuning(juce::MidiBuffer& midi, int stamp) {
    if (chance.share() < 0.5) {
        std::vector<juce::uint8> content{0x7f, 0x7f, 0x08, 0x02, 0, 1}; // single note change
        for (int i = 0; i < 4; ++i)
            content.push_back(static_cast<juce::uint8>(chance.below(128)));
        addSystemExclusive(midi, content, stamp);
        return;
    }
    const bool isZone = chance.share() < 0.5;
    const int channel = isZone ? 1 + 15 * chance.below(2) : 1 + chance.below(channels);
    control(midi, channel, midi::registeredMsb, 0, stamp);
    control(midi, channel, midi::registeredLsb, isZone ? 6 : 0, stamp);
    control(midi, channel, midi::dataEntryMsb, chance.below(25), stamp);
}

/// Adds a controller and updates the pending releases. If it releases keys and pedals of a channel,
/// they are no longer pending.
void RandomMusic::control(juce::MidiBuffer& midi, int channel, int number, int value, int stamp) {
    addController(midi, channel, number, value, stamp);
    if (number == midi::sustainPedal)
        pedalsDown[channel].sustains = value >= 64;
    else if (number == midi::sostenutoPedal)
        pedalsDown[channel].catches = value >= 64;
    else if (number == midi::resetControllers)
        pedalsDown.erase(channel);
    else if (number == midi::allSoundOff || number == midi::allNotesOff)
        std::erase_if(keysDown, [&](const auto& key) { return key.first.first == channel; });
}

/// Adds the releases due up to sample `last` of the block.
void RandomMusic::addDueReleases(juce::MidiBuffer& midi, const Block& block, int last) {
    std::erase_if(keysDown, [&](const auto& key) {
        const auto& [played, end] = key;
        if (end > block.start + last)
            return false;
        const auto stamp = static_cast<int>(std::max<std::int64_t>(end - block.start, 0));
        midi.addEvent(juce::MidiMessage::noteOff(played.first, played.second), stamp);
        return true;
    });
}

} // namespace idiophone::test
