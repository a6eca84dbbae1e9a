// Opens a window without a screen, and runs its timers.
#pragma once

#include "Plugin/Processor.h"
#include "Support/WaitUntil.h"

#include <functional>
#include <memory>

namespace idiophone::test {

inline std::unique_ptr<juce::AudioProcessorEditor> open(Processor& processor) {
    return std::unique_ptr<juce::AudioProcessorEditor>(processor.createEditor());
}

/// Runs the timers of windows until the condition holds.
inline void runTimersUntil(const std::function<bool()>& condition) {
    waitUntil(condition, [] { juce::Timer::callPendingTimersSynchronously(); });
}

} // namespace idiophone::test
