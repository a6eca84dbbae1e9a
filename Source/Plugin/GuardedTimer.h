// A message-thread timer whose owner may be destroyed on any thread.
#pragma once

#include <functional>
#include <memory>

namespace idiophone {

/// JUCE holds no lock while it calls a timer back, so `stopTimer` does not wait for a running call.
/// Hosts of some formats remove a plugin on another thread meanwhile.
class GuardedTimer {
public:
    /// Calls back on the message thread, once per interval.
    GuardedTimer(int milliseconds, std::function<void()> callback);
    /// [any thread] Waits for a running call, unless that call destroys the timer. No call comes
    /// afterwards.
    ~GuardedTimer();
    /// [any thread except the audio thread] Calls back once more, as soon as possible.
    void callSoon();
    GuardedTimer(const GuardedTimer&) = delete;
    GuardedTimer& operator=(const GuardedTimer&) = delete;

private:
    class Ticker;
    std::shared_ptr<Ticker> ticker;
};

} // namespace idiophone
