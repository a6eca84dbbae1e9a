// Makes a keyboard of small synthetic objects inside a state, for plugin tests without factory
// content.
#pragma once

#include "Object/ModalObjectFile.h"
#include "Plugin/Processor.h"
#include "Plugin/State.h"
#include "Support/SyntheticObject.h"

#include <cmath>
#include <juce_audio_basics/juce_audio_basics.h>
#include <random>
#include <string>
#include <vector>

namespace idiophone::test {

constexpr int lowestTestNote = 60, highestTestNote = 72;
constexpr double testRateHz = 48000;
constexpr int testBlockSize = 512;

/// Returns a state of twelve modes a key, played by MIDI notes 60 to 72. `folder` distinguishes
/// sounds.
inline State testState(const std::string& folder = "test", double transpose = 1) {
    State state;
    state.preset.name = "Test keyboard";
    state.preset.keyMap = {.kind = KeyMapKind::bars,
                           .lowestNote = lowestTestNote,
                           .highestNote = highestTestNote,
                           .resizedFrom = 1,
                           .resizedTo = 0, // no other keys sound
                           .object = folder + "/{note}"};
    for (int note = lowestTestNote; note <= highestTestNote; ++note) {
        std::vector<double> frequenciesHz;
        const double lowestHz = transpose * 440 * std::exp2((note - 69) / 12.0);
        for (int mode = 1; mode <= 12; ++mode)
            frequenciesHz.push_back(lowestHz * std::pow(mode, 1.37));
        auto object = syntheticObject(frequenciesHz, std::vector<float>(12, 0.2f));
        object.name = folder + std::to_string(note);
        state.objects.push_back(
            {.name = folder + "/" + std::to_string(note), .modal = encodeModalObject(object)});
    }
    state.preset.parameters.set(ParameterId::malletHardness, 20000);
    state.parameters = state.preset.parameters;
    return state;
}

/// Adds a tube under every key, coupled to its lowest mode.
inline State overTubes(State state) {
    for (auto& object : state.objects) {
        auto bar = readModalObject(object.modal, object.name).value();
        bar.gains.assign(bar.modeCount(), 1);
        bar.gains.front() = {1.5f, 0.5f};
        object.modal = encodeModalObject(bar);
    }
    return state;
}

inline void restore(Processor& processor, const State& state) {
    const auto bytes = encodeState(state);
    processor.setStateInformation(bytes.data(), static_cast<int>(bytes.size()));
}

inline std::string saved(Processor& processor) {
    juce::MemoryBlock block;
    processor.getStateInformation(block);
    return {static_cast<const char*>(block.getData()), block.getSize()};
}

inline void restoreBytes(Processor& processor, const std::string& bytes) {
    processor.setStateInformation(bytes.data(), static_cast<int>(bytes.size()));
}

/// Returns notes, releases, bends and pedals at times from 0 to `samples`; always the same ones.
inline juce::MidiBuffer testMusic(int samples,
                                  int spacing = 701,
                                  const InstrumentView::KeyRange& keys = {lowestTestNote,
                                                                          highestTestNote}) {
    std::mt19937 random(7);
    const auto between = [&](int low, int high) {
        return std::uniform_int_distribution<int>(low, high)(random);
    };
    juce::MidiBuffer midi;
    for (int stamp = 3; stamp < samples; stamp += spacing) {
        const int note = between(keys.lowest, keys.highest);
        midi.addEvent(juce::MidiMessage::noteOn(1, note, static_cast<juce::uint8>(between(1, 127))),
                      stamp);
        midi.addEvent(juce::MidiMessage::noteOff(1, note), stamp + spacing / 2);
        midi.addEvent(juce::MidiMessage::pitchWheel(1, between(0, 16383)), stamp + 5);
        midi.addEvent(juce::MidiMessage::controllerEvent(1, 64, between(0, 127)), stamp + 9);
    }
    return midi;
}

/// The output that a host receives; a mono output is in `left`.
struct HostSound {
    std::vector<float> left, right;

    bool operator==(const HostSound&) const = default;

    void append(const HostSound& later) {
        left.insert(left.end(), later.left.begin(), later.left.end());
        right.insert(right.end(), later.right.begin(), later.right.end());
    }
    void append(const juce::AudioBuffer<float>& later) {
        const auto append = [&](std::vector<float>& samples, int channel) {
            const auto* from = later.getReadPointer(channel);
            samples.insert(samples.end(), from, from + later.getNumSamples());
        };
        append(left, 0);
        if (later.getNumChannels() > 1)
            append(right, 1);
    }
};

/// Renders as a host does, in blocks of one size.
inline HostSound render(Processor& processor,
                        int samples,
                        int blockSize,
                        const juce::MidiBuffer& midi,
                        int channels = 2) {
    HostSound output;
    juce::AudioBuffer<float> buffer(channels, blockSize);
    for (int start = 0; start < samples; start += blockSize) {
        const int count = std::min(blockSize, samples - start);
        buffer.setSize(channels, count, false, false, true);
        for (int channel = 0; channel < channels; ++channel)
            buffer.clear(channel, 0, count);
        juce::MidiBuffer block;
        block.addEvents(midi, start, count, -start);
        processor.processBlock(buffer, block);
        output.append(buffer);
    }
    return output;
}

inline float loudest(const std::vector<float>& samples) {
    float result = 0;
    for (const float sample : samples)
        result = std::isfinite(sample) ? std::max(result, std::abs(sample))
                                       : std::numeric_limits<float>::infinity();
    return result;
}

inline float loudest(const HostSound& sound) {
    return std::max(loudest(sound.left), loudest(sound.right));
}

inline bool allFinite(const HostSound& sound) {
    return std::isfinite(loudest(sound));
}

} // namespace idiophone::test
