// Times contestants side by side on a noisy machine: many short windows of each in random order.
// The minimum counts. Google Benchmark does the timing.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace idiophone {

using Contestant = std::function<void()>;

struct TimingWindows {
    int count = 50;        ///< windows of each contestant
    double seconds = 2e-3; ///< length of a window, shorter than a scheduler's slice
};

/// Returns the processor seconds of one call of each contestant: the minimum over its windows, each
/// with many calls. A first call is not counted.
std::vector<double> leastSeconds(std::span<const Contestant> contestants,
                                 const TimingWindows& windows = {});

/// Calls each contestant `times` times, one call at a time in random order.
void callInTurn(std::span<const Contestant> contestants, int times);

/// The minimum time of each step of a repeated sequence. Replays of the same work remove noise step
/// by step.
class LeastStepTimes {
public:
    /// Runs and times steps 0 to count − 1.
    void replay(std::size_t count, const std::function<void(std::size_t step)>& run);

    std::span<const double> seconds() const { return least; }
    /// Returns the sum over steps `from` to `until` − 1.
    double sum(std::size_t from, std::size_t until) const;
    double sum() const { return sum(0, least.size()); }

private:
    std::vector<double> least;
};

} // namespace idiophone
