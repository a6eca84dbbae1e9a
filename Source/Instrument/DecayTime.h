// Converts decay times (T60) to decay rates.
#pragma once

namespace idiophone {

/// Returns d [1/s] such that e^(−dt) falls by 60 dB in that time: ln(1000)/T60.
constexpr double decayPerSecond(double t60Seconds) {
    return 6.907755278982137 / t60Seconds;
}

} // namespace idiophone
