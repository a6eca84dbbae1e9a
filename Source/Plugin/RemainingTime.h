// Estimates how long work still takes, from its progress.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

namespace idiophone {

/// The caller gives the time.
class RemainingTime {
public:
    using Time = std::chrono::steady_clock::time_point;

    void start(Time now) {
        began = now;
        ends.reset();
    }
    /// `fraction` of the work is done, 0 to 1. Estimates nothing before a twentieth and a second
    /// have passed.
    void report(double fraction, Time now) {
        const std::chrono::duration<double> passed = now - began;
        if (fraction >= 0.05 && passed.count() >= 1)
            ends = began + std::chrono::duration_cast<Time::duration>(passed / fraction);
    }
    /// Returns whole seconds from 1 up, above 10 in steps of 5. It falls while nothing is reported,
    /// and returns nothing once the work takes longer than estimated.
    std::optional<int> seconds(Time now) const {
        if (!ends || now >= *ends)
            return std::nullopt;
        const double left = std::chrono::duration<double>(*ends - now).count();
        const int step = left > 10 ? 5 : 1;
        return std::max(1, step * static_cast<int>(std::lround(left / step)));
    }

private:
    Time began;
    std::optional<Time> ends;
};

} // namespace idiophone
