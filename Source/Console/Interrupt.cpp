#include "Console/Interrupt.h"

#include <array>
#include <csignal>

namespace idiophone {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

constexpr std::array wishes{
    SIGINT, SIGTERM,
#ifdef SIGHUP
    SIGHUP, // the terminal was closed
#endif
};

extern "C" void handleInterrupt(int wish) {
    interrupted = true;
    std::signal(wish, SIG_DFL);
}

} // namespace

const std::atomic<bool>& interruptRequested() {
    [[maybe_unused]] static const bool listens = [] {
        for (const int wish : wishes)
            if (std::signal(wish, handleInterrupt) == SIG_IGN)
                std::signal(wish, SIG_IGN); // nohup and shells set this for background processes
        return true;
    }();
    return interrupted;
}

} // namespace idiophone
