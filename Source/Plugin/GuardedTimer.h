// A timer of the message thread whose owner may go on any thread.
#pragma once

#include <functional>
#include <memory>

namespace idiophone {

/// JUCE calls a timer back with no lock held, so that `stopTimer` does not wait for a call that is
/// under way; and hosts of some formats remove a plugin on a thread of their own meanwhile.
class GuardedTimer {
public:
    /// Calls back on the message thread every so often.
    GuardedTimer(int milliseconds, std::function<void()> callback);
    /// Any thread: waits for a call that is under way, unless that is what destroys it; none comes
    /// after.
    ~GuardedTimer();
    /// [any thread but audio in real time] Calls back once more, as soon as the message thread can.
    void callSoon();
    GuardedTimer(const GuardedTimer&) = delete;
    GuardedTimer& operator=(const GuardedTimer&) = delete;

private:
    class Ticker;
    std::shared_ptr<Ticker> ticker;
};

} // namespace idiophone
