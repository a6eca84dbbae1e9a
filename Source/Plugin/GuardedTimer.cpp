#include "Plugin/GuardedTimer.h"

#include <juce_events/juce_events.h>
#include <utility>

namespace idiophone {

class GuardedTimer::Ticker final : public juce::Timer {
public:
    explicit Ticker(std::function<void()> calledBack) : callback(std::move(calledBack)) {}

    void end() {
        stopTimer();
        const juce::ScopedLock lock(calling);
        isOver = true;
    }

    void timerCallback() override {
        const juce::ScopedLock lock(calling); // recursive
        if (!isOver)
            callback();
    }

private:
    const std::function<void()> callback;
    juce::CriticalSection calling;
    bool isOver = false;
};

GuardedTimer::GuardedTimer(int milliseconds, std::function<void()> callback)
    : ticker(std::make_shared<Ticker>(std::move(callback))) {
    ticker->startTimer(milliseconds);
}

void GuardedTimer::callSoon() {
    juce::MessageManager::callAsync([called = ticker] { called->timerCallback(); });
}

GuardedTimer::~GuardedTimer() {
    ticker->end();
    // The message thread may be about to call the ticker: delete it there, after that call.
    juce::MessageManager::callAsync([last = std::move(ticker)] {});
}

} // namespace idiophone
