// Logs what the host receives from a parameter: "(" and ")" for the start and end of a gesture, "="
// for a value.
#pragma once

#include <juce_audio_processors/juce_audio_processors.h>

namespace idiophone::test {

struct GestureLog final : juce::AudioProcessorListener {
    void audioProcessorParameterChanged(juce::AudioProcessor*, int, float) override { text += "="; }
    void audioProcessorChanged(juce::AudioProcessor*, const ChangeDetails&) override {}
    void audioProcessorParameterChangeGestureBegin(juce::AudioProcessor*, int) override {
        text += "(";
    }
    void audioProcessorParameterChangeGestureEnd(juce::AudioProcessor*, int) override {
        text += ")";
    }

    juce::String text;
};

} // namespace idiophone::test
