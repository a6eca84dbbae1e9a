// Opens a window without a screen, and runs its timers.
#pragma once

#include "Plugin/Processor.h"

#include <functional>
#include <memory>

namespace idiophone::test {

inline std::unique_ptr<juce::AudioProcessorEditor> open(Processor& processor) {
    return std::unique_ptr<juce::AudioProcessorEditor>(processor.createEditor());
}

/// Runs the timers until the condition holds, for about 5 s at most. Returns whether it holds.
inline bool holdsSoon(const std::function<bool()>& condition) {
    for (int i = 0; i < 500 && !condition(); ++i) {
        juce::Thread::sleep(10);
        juce::Timer::callPendingTimersSynchronously();
    }
    return condition();
}

} // namespace idiophone::test
