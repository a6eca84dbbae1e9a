// Decay times as people know them, and as dampers have them.
#pragma once

namespace idiophone {

/// d [1/s] of e^(−dt) that falls by 60 dB in that time: ln(1000)/T60.
constexpr double decayPerSecond(double t60Seconds) {
    return 6.907755278982137 / t60Seconds;
}

} // namespace idiophone
