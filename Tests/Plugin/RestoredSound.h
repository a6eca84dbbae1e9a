// A state with unusual values, and the sound of an instance that restored it.
#pragma once

#include "Support/TestSound.h"

namespace idiophone::test {

constexpr int blockSamples = 4800;

inline juce::MidiBuffer chord() {
    juce::MidiBuffer midi;
    for (const int note : {60, 64, 67})
        midi.addEvent(juce::MidiMessage::noteOn(1, note, static_cast<juce::uint8>(100)), 10);
    return midi;
}

inline State unusualState() {
    auto state = testState();
    state.parameters.set(ParameterId::size, 1.2345678901234567);
    state.parameters.set(ParameterId::material, customMaterial);
    state.parameters.set(ParameterId::youngsModulus, 70.1);
    state.parameters.set(ParameterId::level, -3.3);
    return state;
}

inline HostSound firstBlock(Processor& processor) {
    return render(processor, blockSamples, blockSamples, chord());
}

/// Returns the first block of a fresh instance that restored the state before it was prepared.
inline HostSound reference(const State& state) {
    Processor processor;
    restore(processor, state);
    processor.prepareToPlay(48000, blockSamples);
    return firstBlock(processor);
}

} // namespace idiophone::test
