// Times contestants side by side on a noisy machine: many short windows of each in random order.
// The minimum counts. Google Benchmark does the timing.
#pragma once

#include "Benchmarks/Scene.h"

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
/// with many calls. The first call of each is not counted.
std::vector<double> leastSeconds(std::span<const Contestant> contestants,
                                 const TimingWindows& windows = {});

/// A sequence of cells that can be rendered again.
struct Replay {
    std::function<void()> restart;
    std::function<void(std::size_t cell)> render;
};

Replay replayOf(BenchScene& scene);

/// The minimum time of each cell over its replays, which removes noise cell by cell.
struct CellTimes {
    std::vector<double> seconds;

    /// Returns the sum over cells `from` to `until` − 1.
    double sum(std::size_t from, std::size_t until) const;
    double sum() const { return sum(0, seconds.size()); }
};

/// Renders `cells` cells of each contestant `times` times, one replay at a time in random order.
std::vector<CellTimes>
replayInTurn(std::span<const Replay> contestants, std::size_t cells, int times);

} // namespace idiophone
