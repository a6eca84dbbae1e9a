// Ctrl-C as a wish to stop, so that files half written are taken away. A second Ctrl-C kills.
#pragma once

#include <atomic>
#include <string_view>

namespace idiophone {

/// From the first call on, Ctrl-C sets what it returns instead of ending the program.
const std::atomic<bool>& interruptRequested();

/// The error of a rendering that was stopped.
inline constexpr std::string_view interruptedMessage = "It was interrupted.";

} // namespace idiophone
