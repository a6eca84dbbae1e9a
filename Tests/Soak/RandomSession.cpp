#include "Soak/RandomSession.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace idiophone::test {
namespace {

constexpr int largestBlock = 4096;
constexpr std::size_t keptStates = 8;
// How often in a block something happens.
constexpr double notesPerSecond = 12;
constexpr double automationShare = 0.3, soundShare = 0.004, hostShare = 0.0005;

std::string savedState(Processor& processor) {
    juce::MemoryBlock block;
    processor.getStateInformation(block);
    return {static_cast<const char*>(block.getData()), block.getSize()};
}

void restoreState(Processor& processor, const std::string& state) {
    processor.setStateInformation(state.data(), static_cast<int>(state.size()));
}

} // namespace

RandomSession::RandomSession(Processor& played, Changes whatChanges)
    : processor(played), changes(whatChanges), reference(savedState(played)) {
    processor.setNonRealtime(changes == Changes::all);
    processor.prepareToPlay(rateHz, largestBlock);
}

void RandomSession::play(double seconds, std::uint64_t seed) {
    random.seed(static_cast<std::mt19937::result_type>(seed));
    const auto end = samples + static_cast<std::int64_t>(seconds * rateHz);
    while (samples < end) {
        constexpr std::array lengths{1, 32, 64, 128, 333, 512, 1024, largestBlock};
        const int length = lengths[static_cast<std::size_t>(below(lengths.size()))];
        if (share() < automationShare)
            moveParameter();
        if (changes == Changes::all && share() < soundShare)
            changeSound();
        if (changes == Changes::all && share() < hostShare)
            changeHost();
        juce::MidiBuffer midi;
        addMusic(midi, length);
        render(midi, length);
    }
}

void RandomSession::addMusic(juce::MidiBuffer& midi, int length) {
    const auto keys = processor.keyRange();
    const double expected = notesPerSecond * length / rateHz;
    const int count = static_cast<int>(expected) + (share() < expected - std::floor(expected));
    for (int i = 0; i < count; ++i) {
        const int channel = share() < 0.8 ? 1 : 1 + below(16);
        const int note = keys.lowest + below(keys.highest - keys.lowest + 1);
        const int stamp = below(length);
        midi.addEvent(
            juce::MidiMessage::noteOn(channel, note, static_cast<juce::uint8>(1 + below(127))),
            stamp);
        midi.addEvent(juce::MidiMessage::noteOff(channel, below(128)), below(length));
        ++notes;
        switch (below(8)) {
        case 0:
            midi.addEvent(juce::MidiMessage::pitchWheel(channel, below(16384)), stamp);
            break;
        case 1:
            midi.addEvent(juce::MidiMessage::channelPressureChange(channel, below(128)), stamp);
            break;
        case 2:
            midi.addEvent(juce::MidiMessage::aftertouchChange(channel, note, below(128)), stamp);
            break;
        case 3: {
            constexpr std::array controllers{1, 6, 38, 64, 66, 67, 74, 100, 101, 120, 121, 123};
            const int number = controllers[static_cast<std::size_t>(below(controllers.size()))];
            midi.addEvent(juce::MidiMessage::controllerEvent(channel, number, below(128)), stamp);
            break;
        }
        default:
            break;
        }
    }
}

void RandomSession::moveParameter() {
    const auto& parameters = processor.getParameters();
    auto* parameter = parameters[below(parameters.size())];
    if (parameter == processor.getBypassParameter())
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
        for (auto* parameter : processor.getParameters())
            parameter->setValue(parameter->getDefaultValue());
        break;
    default:
        processor.setCurrentProgram(below(processor.getNumPrograms()));
        break;
    }
}

void RandomSession::changeHost() {
    constexpr std::array rates{22050.0, 44100.0, 48000.0, 96000.0};
    if (share() < 0.5) {
        processor.reset();
        return;
    }
    rateHz = rates[static_cast<std::size_t>(below(rates.size()))];
    processor.releaseResources();
    processor.prepareToPlay(rateHz, largestBlock);
}

void RandomSession::render(juce::MidiBuffer& midi, int length) {
    buffer.setSize(2, length, false, false, true);
    buffer.clear();
    processor.processBlock(buffer, midi);
    samples += length;
    loudest = sumOfSquares = 0;
    for (int channel = 0; channel < 2; ++channel)
        for (int i = 0; i < length; ++i) {
            const double sample = buffer.getSample(channel, i);
            if (!std::isfinite(sample))
                throw std::runtime_error("Sample " + std::to_string(samples - length + i) +
                                         " is not finite.");
            loudest = std::max(loudest, std::abs(sample));
            sumOfSquares += sample * sample;
        }
}

void RandomSession::settle(double longestSeconds) {
    for (auto* parameter : processor.getParameters())
        parameter->setValue(parameter->getDefaultValue());
    processor.changeParameter(ParameterId::letRing, 0);
    juce::MidiBuffer midi;
    for (int channel = 1; channel <= 16; ++channel) {
        midi.addEvent(juce::MidiMessage::controllerEvent(channel, 121, 0), 0);
        midi.addEvent(juce::MidiMessage::controllerEvent(channel, 123, 0), 0);
    }
    for (double waited = 0; waited < longestSeconds; waited += largestBlock / rateHz) {
        render(midi, largestBlock);
        midi.clear();
        if (loudest == 0)
            return;
    }
    throw std::runtime_error("Something still sounds, at " + std::to_string(loudest) +
                             ", when every key was up for " + std::to_string(longestSeconds) +
                             " seconds.");
}

double RandomSession::referenceLevel() {
    restoreState(processor, reference);
    rateHz = 48000;
    processor.prepareToPlay(rateHz, largestBlock);
    juce::MidiBuffer midi;
    for (int i = 0; i < 8; ++i)
        midi.addEvent(juce::MidiMessage::noteOn(1, 72 + 4 * i, juce::uint8{100}), 400 * i);
    double sum = 0;
    for (int block = 0; block < 24; ++block) {
        render(midi, largestBlock);
        midi.clear();
        sum += sumOfSquares;
    }
    return std::sqrt(sum / (2.0 * 24 * largestBlock));
}

} // namespace idiophone::test
