#include "Soak/RandomSession.h"

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
// Probability of each event in a block.
constexpr double automationShare = 0.3, soundShare = 0.004, hostShare = 0.0005;

std::string savedState(Processor& processor) {
    juce::MemoryBlock block;
    processor.getStateInformation(block);
    return {static_cast<const char*>(block.getData()), block.getSize()};
}

void restoreState(Processor& processor, const std::string& state) {
    processor.setStateInformation(state.data(), static_cast<int>(state.size()));
}

/// Sets exact values; the values of a host would be rounded.
void setToDefaults(Processor& processor) {
    for (const auto& info : parameterTable())
        processor.parameters()[info.parameter].changeByHand(info.defaultValue);
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
    while (processor.view().stage.hasStage());
    prepare(48000);
}

void RandomSession::play(double seconds, std::uint64_t seed, double notesPerSecond) {
    chance.seed(seed);
    processor.setNonRealtime(changes == Changes::all);
    const auto end = samples + static_cast<std::int64_t>(seconds * rateHz);
    juce::MidiBuffer midi;
    music.endSlide();
    if (changes == Changes::parameters && chance.share() < 0.7) {
        // A slow contact as long as the music.
        const double kind = scrapeContact + chance.below(3);
        processor.getParameters()[static_cast<int>(contact)]->setValue(
            static_cast<float>(parameterInfo(contact).toNormalised(kind)));
        music.slide(midi, processor.view().instrument.keyRange(), end);
    }
    while (samples < end) {
        constexpr std::array lengths{1, 32, 64, 128, 333, 512, 1024, largestBlock};
        const int length = lengths[static_cast<std::size_t>(chance.below(lengths.size()))];
        if (chance.share() < automationShare)
            moveParameter();
        if (changes == Changes::all && chance.share() < soundShare)
            changeSound();
        if (changes == Changes::all && chance.share() < hostShare)
            changeHost();
        music.add(midi,
                  {.start = samples,
                   .length = length,
                   .rateHz = rateHz,
                   .keys = processor.view().instrument.keyRange()},
                  notesPerSecond * length / rateHz);
        render(midi, length);
        midi.clear();
        if (changes == Changes::parameters && juce::MessageManager::existsAndIsCurrentThread())
            juce::Timer::callPendingTimersSynchronously(); // run the plugin's own polls too
    }
}

void RandomSession::moveParameter() {
    const auto& parameters = processor.getParameters();
    const int index = chance.below(parameters.size());
    auto* parameter = parameters[index];
    if (parameter == processor.getBypassParameter() ||
        (music.isSliding() && index == static_cast<int>(contact)))
        return;
    constexpr std::array places{0.0f, 0.5f, 1.0f};
    parameter->setValue(chance.share() < 0.3 ? places[static_cast<std::size_t>(chance.below(3))]
                                             : static_cast<float>(chance.share()));
}

void RandomSession::changeSound() {
    switch (chance.below(4)) {
    case 0:
        if (states.size() == keptStates)
            states.erase(states.begin());
        states.push_back(savedState(processor));
        break;
    case 1:
        if (!states.empty())
            restoreState(
                processor,
                states[static_cast<std::size_t>(chance.below(static_cast<int>(states.size())))]);
        break;
    case 2:
        setToDefaults(processor);
        break;
    default:
        processor.setCurrentProgram(chance.below(processor.getNumPrograms()));
        break;
    }
}

void RandomSession::changeHost() {
    constexpr std::array rates{22050.0, 44100.0, 48000.0, 96000.0};
    if (chance.share() < 0.5)
        processor.reset();
    else
        prepare(rates[static_cast<std::size_t>(chance.below(rates.size()))]);
}

void RandomSession::render(juce::MidiBuffer& midi, int length) {
    buffer.setSize(2, length, false, false, true);
    buffer.clear();
    processor.processBlock(buffer, midi);
    samples += length;
    if (processor.engineReport().notFinite > 0) // the output is silent then
        throw std::runtime_error("What was rendered up to sample " + std::to_string(samples) +
                                 " was not finite.");
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
    // A stage has no dampers. Otherwise only dampers end the sound.
    if (!processor.view().stage.hasStage()) {
        processor.parameters()[letRing].changeByHand(0);
        processor.parameters()[material].changeByHand(customMaterial);
        processor.parameters()[fluidDamping].changeByHand(0);
        processor.parameters()[viscoelasticDamping].changeByHand(0);
    }
    releaseAll();
    awaitSilence("every key and pedal went up");
    if (processor.view().stage.hasStage())
        return;
    juce::MidiBuffer midi;
    const auto keys = processor.view().instrument.keyRange();
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
    const double way = chance.share();
    if (way < 0.6) {
        music.addOwed(midi);
    } else if (way < 0.8 || changes == Changes::parameters) {
        addEndOfNotes(midi);
    } else {
        processor.reset();
    }
    music.forget();
    render(midi, largestBlock);
}

void RandomSession::awaitSilence(const char* after) {
    const double longestSeconds = processor.view().stage.hasStage() ? 120 : 2;
    juce::MidiBuffer none;
    for (double waited = 0; waited < longestSeconds; waited += largestBlock / rateHz) {
        render(none, largestBlock);
        if (loudest == 0)
            return;
    }
    throw std::runtime_error("Something still sounds, at " + std::to_string(loudest) + ", " +
                             std::to_string(longestSeconds) + " seconds after " + after + ".");
}

/// Resets parameters, controllers and tuning.
void RandomSession::putBack() {
    setToDefaults(processor);
    processor.parameters()[strikeSpread].changeByHand(0);
    juce::MidiBuffer midi;
    addDefaults(midi);
    // Let glides and fades end.
    for (double waited = 0; waited < 1; waited += largestBlock / rateHz) {
        render(midi, largestBlock);
        midi.clear();
    }
}

PlayedPhrase RandomSession::renderPhrase() {
    PlayedPhrase phrase;
    const auto keys = processor.view().instrument.keyRange();
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
    processor.parameters()[contact].changeByHand(rollContact);
    processor.parameters()[motorSpeed].changeByHand(turnsPerSecond);
    processor.parameters()[motorDepth].changeByHand(100);
    const int note = processor.view().instrument.keyRange().lowest;
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
                                         rateHz); // the disc opens twice a turn
    }
    midi.addEvent(juce::MidiMessage::noteOff(1, note), 0);
    render(midi, largestBlock);
    return std::abs(turning) / all;
}

} // namespace idiophone::test
