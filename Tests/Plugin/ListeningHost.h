// A host that records parameter changes, and a wait in which timers run.
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

inline void followTimers(int milliseconds) {
    for (int i = 0; i < milliseconds; i += 5) {
        juce::Thread::sleep(5);
        juce::Timer::callPendingTimersSynchronously();
    }
}

} // namespace idiophone::test
