// A host that records parameter changes, and polls in place of its timer.
#pragma once

#include "Plugin/Processor.h"

#include <vector>

namespace idiophone::test {

/// Records the values sent for one parameter.
struct ListeningHost final : juce::AudioProcessorListener {
    explicit ListeningHost(ParameterId listened) : parameter(static_cast<int>(listened)) {}
    void audioProcessorParameterChanged(juce::AudioProcessor*, int index, float value) override {
        if (index == parameter)
            heard.push_back(value);
    }
    void audioProcessorChanged(juce::AudioProcessor*, const ChangeDetails&) override {}
    int parameter;
    std::vector<float> heard;
};

/// Polls more times than any report to the host needs.
inline void pollOften(Processor& processor) {
    for (int polls = 0; polls < 6; ++polls)
        processor.poll();
}

} // namespace idiophone::test
