// Turns Ctrl-C and other termination signals into a request to stop, so that partial files are
// removed. A second signal kills the program.
#pragma once

#include <atomic>
#include <string_view>

namespace idiophone {

/// The first call installs the handler. From then on a signal sets the returned flag instead of
/// ending the program.
const std::atomic<bool>& interruptRequested();

inline constexpr std::string_view interruptedMessage = "It was interrupted.";

} // namespace idiophone
