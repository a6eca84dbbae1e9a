// Ctrl-C, and what else asks a program to end, as a wish to stop, so that files half written are
// taken away. A second one kills.
#pragma once

#include <atomic>
#include <string_view>

namespace idiophone {

/// From the first call on, such a signal sets what it returns instead of ending the program.
const std::atomic<bool>& interruptRequested();

/// The error of a rendering that was stopped.
inline constexpr std::string_view interruptedMessage = "It was interrupted.";

} // namespace idiophone
