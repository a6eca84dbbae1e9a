#include "Soak/RandomSession.h"

#include "Instrument/MidiControllers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace idiophone::test {
namespace {

using enum ParameterId;

constexpr int largestBlock = 4096;
constexpr std::size_t keptStates = 8;
// How often in a block something happens.
constexpr double automationShare = 0.3, soundShare = 0.004, hostShare = 0.0005;
constexpr double longNoteShare = 0.02; // of notes: those that last up to a minute
constexpr int channels = 16;
constexpr int centredWheel = 8192;

std::string savedState(Processor& processor) {
    juce::MemoryBlock block;
    processor.getStateInformation(block);
    return {static_cast<const char*>(block.getData()), block.getSize()};
}

void restoreState(Processor& processor, const std::string& state) {
    processor.setStateInformation(state.data(), static_cast<int>(state.size()));
}

/// To the last bit, which a host's values are not.
void setToDefaults(Processor& processor) {
    for (const auto& info : parameterTable())
        processor.setValue(info.parameter, info.defaultValue);
}

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
    content.resize(content.size() + 16, ' '); // its name
    for (juce::uint8 note = 0; note < 128; ++note)
        content.insert(content.end(), {note, 0, 0});
    const int sum = std::accumulate(content.begin(), content.end(), 0,
                                    [](int all, juce::uint8 byte) { return all ^ byte; });
    content.push_back(static_cast<juce::uint8>(sum & 0x7f));
    addSystemExclusive(midi, content, stamp);
}

} // namespace

double rmsLevel(const PlayedPhrase& phrase) {
    const double sum = std::inner_product(phrase.begin(), phrase.end(), phrase.begin(), 0.0);
    return std::sqrt(sum / static_cast<double>(phrase.size()));
}

RandomSession::RandomSession(Processor& played, Changes whatChanges)
    : processor(played), changes(whatChanges), reference(savedState(played)) {
    prepare(rateHz);
}

void RandomSession::prepare(double newRateHz) {
    rateHz = newRateHz;
    processor.setNonRealtime(changes == Changes::all);
    processor.releaseResources();
    processor.prepareToPlay(rateHz, largestBlock);
}

void RandomSession::load(int program) {
    const int programs = processor.getNumPrograms();
    do
        processor.setCurrentProgram(program++ % programs);
    while (processor.hasStage());
    prepare(48000);
}

void RandomSession::play(double seconds, std::uint64_t seed, double notesPerSecond) {
    random.seed(static_cast<std::mt19937::result_type>(seed));
    processor.setNonRealtime(changes == Changes::all);
    const auto end = samples + static_cast<std::int64_t>(seconds * rateHz);
    juce::MidiBuffer midi;
    holdsContact = changes == Changes::parameters && share() < 0.7;
    if (holdsContact) {
        // A slide of a slow hand, for as long as the music.
        const double kind = share() < 0.5 ? scrapeContact : rollContact;
        processor.getParameters()[static_cast<int>(contact)]->setValue(
            static_cast<float>(parameterInfo(contact).toNormalised(kind)));
        const auto keys = processor.keyRange();
        const std::pair key{16, keys.lowest + below(keys.highest - keys.lowest + 1)};
        midi.addEvent(juce::MidiMessage::noteOn(key.first, key.second, juce::uint8{20}), 0);
        keysDown[key] = end;
    }
    while (samples < end) {
        constexpr std::array lengths{1, 32, 64, 128, 333, 512, 1024, largestBlock};
        const int length = lengths[static_cast<std::size_t>(below(lengths.size()))];
        if (share() < automationShare)
            moveParameter();
        if (changes == Changes::all && share() < soundShare)
            changeSound();
        if (changes == Changes::all && share() < hostShare)
            changeHost();
        addMusic(midi, length, notesPerSecond * length / rateHz);
        render(midi, length);
        midi.clear();
    }
}

/// In order of time, in which what is owed is noted as it becomes so.
void RandomSession::addMusic(juce::MidiBuffer& midi, int length, double expectedNotes) {
    const int count =
        static_cast<int>(expectedNotes) + (share() < expectedNotes - std::floor(expectedNotes));
    std::vector<int> stamps(static_cast<std::size_t>(count));
    std::ranges::generate(stamps, [&] { return below(length); });
    std::ranges::sort(stamps);
    for (const int stamp : stamps) {
        addOwedReleases(midi, stamp);
        addNote(midi, share() < 0.8 ? 1 : 1 + below(channels), stamp);
    }
    addOwedReleases(midi, length - 1);
}

void RandomSession::addNote(juce::MidiBuffer& midi, int channel, int stamp) {
    const auto keys = processor.keyRange();
    const int note = keys.lowest + below(keys.highest - keys.lowest + 1);
    if (keysDown.contains({channel, note}))
        return; // on every key at most one note a channel, as on a keyboard
    midi.addEvent(
        juce::MidiMessage::noteOn(channel, note, static_cast<juce::uint8>(1 + below(127))), stamp);
    ++notes;
    // Beside a slide none is long, so that it never has to make room.
    const bool isLong = !holdsContact && share() < longNoteShare;
    const double seconds = (isLong ? 60 : 0.5) * share();
    keysDown[{channel, note}] = samples + stamp + 1 + static_cast<std::int64_t>(seconds * rateHz);
    addControllers(midi, channel, note, stamp);
}

void RandomSession::addControllers(juce::MidiBuffer& midi, int channel, int note, int stamp) {
    switch (below(8)) {
    case 0:
        midi.addEvent(juce::MidiMessage::pitchWheel(channel, below(2 * centredWheel)), stamp);
        break;
    case 1:
        midi.addEvent(juce::MidiMessage::channelPressureChange(channel, below(128)), stamp);
        break;
    case 2:
        midi.addEvent(juce::MidiMessage::aftertouchChange(channel, note, below(128)), stamp);
        break;
    case 3: {
        // The last ones end a slide, as what is on any channel.
        constexpr std::array controllers{1, 6, 38, 64, 66, 67, 74, 100, 101, 121, 120, 123};
        const int count = static_cast<int>(controllers.size()) - (holdsContact ? 2 : 0);
        control(midi, channel, controllers[static_cast<std::size_t>(below(count))], below(128),
                stamp);
        break;
    }
    case 4:
        if (share() < 0.1)
            addTuning(midi, stamp);
        break;
    default:
        break;
    }
}

/// Of keys, of the wheel's range or of MPE's zones.
void RandomSession::addTuning(juce::MidiBuffer& midi, int stamp) {
    if (share() < 0.5) {
        std::vector<juce::uint8> content{0x7f, 0x7f, 0x08, 0x02, 0, 1}; // a note, at once
        for (int i = 0; i < 4; ++i)
            content.push_back(static_cast<juce::uint8>(below(128)));
        addSystemExclusive(midi, content, stamp);
        return;
    }
    const bool isZone = share() < 0.5;
    const int channel = isZone ? 1 + 15 * below(2) : 1 + below(channels);
    control(midi, channel, midi::registeredMsb, 0, stamp);
    control(midi, channel, midi::registeredLsb, isZone ? 6 : 0, stamp);
    control(midi, channel, midi::dataEntryMsb, below(25), stamp);
}

/// Notes what is owed after it: keys and pedals of a channel that its host has told to be up are
/// not spoken of again.
void RandomSession::control(juce::MidiBuffer& midi, int channel, int number, int value, int stamp) {
    midi.addEvent(juce::MidiMessage::controllerEvent(channel, number, value), stamp);
    if (number == midi::sustainPedal)
        pedalsDown[channel].sustains = value >= 64;
    else if (number == midi::sostenutoPedal)
        pedalsDown[channel].catches = value >= 64;
    else if (number == midi::resetControllers)
        pedalsDown.erase(channel);
    else if (number == midi::allSoundOff || number == midi::allNotesOff)
        std::erase_if(keysDown, [&](const auto& key) { return key.first.first == channel; });
}

/// Of the block's samples up to this one.
void RandomSession::addOwedReleases(juce::MidiBuffer& midi, int last) {
    std::erase_if(keysDown, [&](const auto& key) {
        const auto& [played, end] = key;
        if (end > samples + last)
            return false;
        const auto stamp = static_cast<int>(std::max<std::int64_t>(end - samples, 0));
        midi.addEvent(juce::MidiMessage::noteOff(played.first, played.second), stamp);
        return true;
    });
}

void RandomSession::moveParameter() {
    const auto& parameters = processor.getParameters();
    const int index = below(parameters.size());
    auto* parameter = parameters[index];
    if (parameter == processor.getBypassParameter() ||
        (holdsContact && index == static_cast<int>(contact)))
        return;
    constexpr std::array places{0.0f, 0.5f, 1.0f};
    parameter->setValue(share() < 0.3 ? places[static_cast<std::size_t>(below(3))]
                                      : static_cast<float>(share()));
}

void RandomSession::changeSound() {
    switch (below(4)) {
    case 0:
        if (states.size() == keptStates)
            states.erase(states.begin());
        states.push_back(savedState(processor));
        break;
    case 1:
        if (!states.empty())
            restoreState(processor,
                         states[static_cast<std::size_t>(below(static_cast<int>(states.size())))]);
        break;
    case 2:
        setToDefaults(processor);
        break;
    default:
        processor.setCurrentProgram(below(processor.getNumPrograms()));
        break;
    }
}

void RandomSession::changeHost() {
    constexpr std::array rates{22050.0, 44100.0, 48000.0, 96000.0};
    if (share() < 0.5)
        processor.reset();
    else
        prepare(rates[static_cast<std::size_t>(below(rates.size()))]);
}

void RandomSession::render(juce::MidiBuffer& midi, int length) {
    buffer.setSize(2, length, false, false, true);
    buffer.clear();
    processor.processBlock(buffer, midi);
    samples += length;
    loudest = 0;
    for (int channel = 0; channel < 2; ++channel)
        for (int i = 0; i < length; ++i) {
            const float sample = buffer.getSample(channel, i);
            if (!std::isfinite(sample))
                throw std::runtime_error("Sample " + std::to_string(samples - length + i) +
                                         " is not finite.");
            loudest = std::max<double>(loudest, std::abs(sample));
        }
}

void RandomSession::settle() {
    setToDefaults(processor);
    // On a stage nothing is damped. Else nothing but dampers ends what rings.
    if (!processor.hasStage()) {
        processor.setValue(letRing, 0);
        processor.setValue(material, customMaterial);
        processor.setValue(fluidDamping, 0);
        processor.setValue(viscoelasticDamping, 0);
    }
    releaseAll();
    awaitSilence("every key and pedal went up");
    if (processor.hasStage())
        return;
    juce::MidiBuffer midi;
    const auto keys = processor.keyRange();
    for (int note = keys.lowest; note <= keys.highest; ++note) {
        midi.addEvent(juce::MidiMessage::noteOn(1, note, juce::uint8{100}), 0);
        render(midi, 512);
        midi.clear();
        midi.addEvent(juce::MidiMessage::noteOff(1, note), 0);
    }
    render(midi, largestBlock);
    awaitSilence("every key was played");
}

void RandomSession::releaseAll() {
    juce::MidiBuffer midi;
    const double way = share();
    if (way < 0.6) {
        for (const auto& [key, end] : keysDown)
            midi.addEvent(juce::MidiMessage::noteOff(key.first, key.second), 0);
        for (const auto& [channel, pedals] : pedalsDown) {
            if (pedals.sustains)
                midi.addEvent(juce::MidiMessage::controllerEvent(channel, midi::sustainPedal, 0),
                              0);
            if (pedals.catches)
                midi.addEvent(juce::MidiMessage::controllerEvent(channel, midi::sostenutoPedal, 0),
                              0);
        }
    } else if (way < 0.8 || changes == Changes::parameters) {
        for (int channel = 1; channel <= channels; ++channel)
            for (const int number : {midi::resetControllers, midi::allNotesOff})
                midi.addEvent(juce::MidiMessage::controllerEvent(channel, number, 0), 0);
    } else {
        processor.reset();
    }
    keysDown.clear();
    pedalsDown.clear();
    render(midi, largestBlock);
}

void RandomSession::awaitSilence(const char* after) {
    const double longestSeconds = processor.hasStage() ? 120 : 2;
    juce::MidiBuffer none;
    for (double waited = 0; waited < longestSeconds; waited += largestBlock / rateHz) {
        render(none, largestBlock);
        if (loudest == 0)
            return;
    }
    throw std::runtime_error("Something still sounds, at " + std::to_string(loudest) + ", " +
                             std::to_string(longestSeconds) + " seconds after " + after + ".");
}

/// Parameters, controllers and tuning.
void RandomSession::putBack() {
    setToDefaults(processor);
    processor.setValue(strikeSpread, 0);
    juce::MidiBuffer midi;
    addEqualTuning(midi, 0);
    for (const int manager : {1, channels}) {
        control(midi, manager, midi::registeredMsb, 0, 0);
        control(midi, manager, midi::registeredLsb, 6, 0);
        control(midi, manager, midi::dataEntryMsb, 0, 0);
    }
    for (int channel = 1; channel <= channels; ++channel) {
        control(midi, channel, midi::registeredMsb, 0, 0);
        control(midi, channel, midi::registeredLsb, 0, 0);
        control(midi, channel, midi::dataEntryMsb, 2, 0);
        control(midi, channel, midi::modulation, 64, 0);
        control(midi, channel, midi::place, 64, 0);
        control(midi, channel, midi::softPedal, 0, 0);
        midi.addEvent(juce::MidiMessage::pitchWheel(channel, centredWheel), 0);
    }
    // What glides or fades arrives.
    for (double waited = 0; waited < 1; waited += largestBlock / rateHz) {
        render(midi, largestBlock);
        midi.clear();
    }
}

PlayedPhrase RandomSession::renderPhrase() {
    PlayedPhrase phrase;
    const auto keys = processor.keyRange();
    juce::MidiBuffer midi;
    for (int i = 0; i < 8; ++i)
        midi.addEvent(juce::MidiMessage::noteOn(
                          1, keys.lowest + (keys.highest - keys.lowest) * i / 7, juce::uint8{100}),
                      400 * i);
    for (int block = 0; block < 24; ++block) {
        render(midi, largestBlock);
        midi.clear();
        for (int i = 0; i < largestBlock; ++i)
            phrase.insert(phrase.end(), {buffer.getSample(0, i), buffer.getSample(1, i)});
    }
    for (int i = 0; i < 8; ++i)
        midi.addEvent(
            juce::MidiMessage::noteOff(1, keys.lowest + (keys.highest - keys.lowest) * i / 7), 0);
    render(midi, largestBlock);
    return phrase;
}

PlayedPhrase RandomSession::phrase() {
    putBack();
    return renderPhrase();
}

PlayedPhrase RandomSession::phraseAfterReset() {
    putBack();
    processor.reset();
    return renderPhrase();
}

PlayedPhrase RandomSession::phraseAnew() {
    restoreState(processor, reference);
    prepare(48000);
    return phraseAfterReset();
}

double RandomSession::tremolo() {
    putBack();
    constexpr double turnsPerSecond = 11, seconds = 10;
    processor.setValue(contact, rollContact);
    processor.setValue(motorSpeed, turnsPerSecond);
    processor.setValue(motorDepth, 100);
    const int note = processor.keyRange().lowest;
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::noteOn(1, note, juce::uint8{100}), 0);
    render(midi, largestBlock);
    midi.clear();
    std::complex<double> turning = 0;
    double all = 0;
    for (int rendered = 0; rendered < seconds * rateHz; rendered += cellSamples) {
        render(midi, cellSamples);
        double power = 0;
        for (int i = 0; i < cellSamples; ++i)
            power += std::pow(buffer.getSample(0, i), 2);
        all += power;
        turning += std::polar(power, 4 * std::numbers::pi * turnsPerSecond * rendered /
                                         rateHz); // twice a turn
    }
    midi.addEvent(juce::MidiMessage::noteOff(1, note), 0);
    render(midi, largestBlock);
    return std::abs(turning) / all;
}

} // namespace idiophone::test
