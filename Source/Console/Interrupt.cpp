#include "Console/Interrupt.h"

#include <csignal>

namespace idiophone {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

extern "C" void handleInterrupt(int) {
    interrupted = true;
    std::signal(SIGINT, SIG_DFL);
}

} // namespace

const std::atomic<bool>& interruptRequested() {
    if (!interrupted)
        std::signal(SIGINT, handleInterrupt);
    return interrupted;
}

} // namespace idiophone
