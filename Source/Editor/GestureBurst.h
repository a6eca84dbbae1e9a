// Joins quick successive changes into one gesture: notches of a mouse wheel, repeats of a key.
#pragma once

#include <functional>
#include <juce_events/juce_events.h>

namespace idiophone {

/// For the message thread. A gesture begins with the first `extend`. It ends with `finish`, after a
/// pause, or on destruction.
class GestureBurst final : private juce::Timer {
public:
    GestureBurst(std::function<void()> begin, std::function<void()> end)
        : onBegin(std::move(begin)), onEnd(std::move(end)) {}
    ~GestureBurst() override { finish(); }

    void extend() {
        if (!isTimerRunning())
            onBegin();
        startTimer(pauseMilliseconds);
    }

    void finish() {
        if (!isTimerRunning())
            return;
        stopTimer();
        onEnd();
    }

private:
    static constexpr int pauseMilliseconds = 500;

    void timerCallback() override { finish(); }

    std::function<void()> onBegin, onEnd;
};

} // namespace idiophone
