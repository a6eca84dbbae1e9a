#include "Benchmarks/Benchmarks.h"
#include "Benchmarks/Timer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <random>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace idiophone {
namespace {

constexpr std::array<std::size_t, 3> bodyCounts{10, 100, 1000};
constexpr double sceneSeconds = 2;
constexpr double strikesPerSecond = 4; // of each body
constexpr int replays = 3;
constexpr double hardestNewtonSeconds = 0.01;
constexpr double strikeRangeDb = 30;
constexpr double contactSeconds = 0.1e-3;
constexpr double frameSeconds = 0.01;

const SynthesisSettings unscaled{.tau = 0.02, .modeBudget = 1e9, .compression = 1, .material = {}};
const SynthesisSettings scaled{.tau = 0.02, .modeBudget = 500, .compression = 1, .material = {}};

/// Returns the bytes in use on the main thread's heap, or nothing if this C library does not report
/// them.
std::optional<std::int64_t> heapBytes() {
#ifdef __GLIBC__
    const auto heap = mallinfo2();
    return static_cast<std::int64_t>(heap.uordblks + heap.hblkhd);
#else
    return std::nullopt;
#endif
}

/// Bodies of one shape in different sizes, each struck repeatedly at its own times.
struct Crowd {
    std::vector<SynthesiserSlot> slots;
    std::vector<SceneStrike> strikes;
};

Crowd crowdOf(const std::shared_ptr<const ModalObject>& object, std::size_t bodies) {
    Crowd crowd;
    std::minstd_rand random(7);
    for (std::size_t body = 0; body < bodies; ++body) {
        crowd.slots.push_back({object, std::exp2(share(random) - 0.5)});
        const double phase = share(random);
        for (int k = 0; k < static_cast<int>(sceneSeconds * strikesPerSecond); ++k) {
            const std::array place{2 * share(random) - 1, 2 * share(random) - 1, 1.0};
            const double newtonSeconds =
                hardestNewtonSeconds * std::pow(10, -strikeRangeDb / 20 * share(random));
            crowd.strikes.push_back(
                {(k + phase) / strikesPerSecond, body,
                 strikeInto(strikePointAt(*object, place), newtonSeconds, contactSeconds)});
        }
    }
    std::ranges::stable_sort(crowd.strikes, {}, &SceneStrike::seconds);
    return crowd;
}

struct Run {
    double modesMixed = 0; ///< mean
    std::int64_t modesMost = 0;
    double meanFrameSeconds = 0; ///< processor time of a frame of a hundredth of a second
    double worstFrameSeconds = 0;
};

Run figuresOf(BenchScene& scene, const CellTimes& times) {
    // Leave out the first half second, in which not all bodies have been struck.
    const std::size_t cells = cellsIn(sceneSeconds), first = cellsIn(0.5);
    const auto modes = scene.modesMixed(cells);
    const auto counted = std::span(modes).subspan(first);
    const auto cellsInFrame = cellsIn(frameSeconds);
    constexpr double cellsOfFrame = frameSeconds / cellSeconds;
    Run run{.modesMixed = meanOf(counted),
            .modesMost = std::ranges::max(counted),
            .meanFrameSeconds =
                times.sum(first, cells) / static_cast<double>(cells - first) * cellsOfFrame};
    for (std::size_t k = first; k + cellsInFrame <= cells; k += cellsInFrame)
        run.worstFrameSeconds =
            std::max(run.worstFrameSeconds, times.sum(k, k + cellsInFrame) /
                                                static_cast<double>(cellsInFrame) * cellsOfFrame);
    return run;
}

nlohmann::ordered_json describe(const Run& run) {
    return {{"modes_mixed_mean", run.modesMixed},
            {"modes_mixed_most", run.modesMost},
            {"frame_seconds_mean", run.meanFrameSeconds},
            {"frame_seconds_worst", run.worstFrameSeconds}};
}

std::string inWords(const Run& run) {
    return figure(run.modesMixed) + " modes on average, " + std::to_string(run.modesMost) +
           " at most; " + figure(1e6 * run.meanFrameSeconds) + " µs a frame, " +
           figure(1e6 * run.worstFrameSeconds) + " at worst";
}

} // namespace

Result<BenchSection> benchScale(const BenchContent& content) {
    const auto rings = objectsNamed(content, "small-ring");
    if (!rings)
        return tl::unexpected(rings.error());
    BenchSection section{.name = "scale",
                         .title = "10, 100 and 1000 rings, each of a size of its own and struck " +
                                  figure(strikesPerSecond) +
                                  " times a second; a frame is a hundredth of a second"};
    section.figures["mode_budget"] = scaled.modeBudget;
    std::map<std::size_t, Run> withBudget, without;
    for (const std::size_t bodies : bodyCounts) {
        const auto crowd = crowdOf(rings->front(), bodies);
        const auto heapBefore = heapBytes();
        BenchScene scaledScene(crowd.slots, crowd.strikes, scaled);
        const auto heapAfter = heapBytes();
        BenchScene freeScene(crowd.slots, crowd.strikes, unscaled);
        const auto times = replayInTurn(std::array{replayOf(scaledScene), replayOf(freeScene)},
                                        cellsIn(sceneSeconds), replays);
        const Run& budgeted = withBudget[bodies] = figuresOf(scaledScene, times[0]);
        const Run& free = without[bodies] = figuresOf(freeScene, times[1]);

        const std::string name = std::to_string(bodies) + " bodies";
        section.row(name + ", no budget", inWords(free));
        section.row(name + ", budget " + figure(scaled.modeBudget), inWords(budgeted));
        nlohmann::ordered_json one{
            {"bodies", bodies}, {"scaled", describe(budgeted)}, {"unscaled", describe(free)}};
        one["heap_bytes"] = nullptr;
        if (heapBefore && heapAfter) {
            // The engine allocates only when it is constructed, so its memory now is its peak.
            const auto bytes = *heapAfter - *heapBefore;
            one["heap_bytes"] = bytes;
            section.row(name + ", memory", figure(static_cast<double>(bytes) / 1e6) + " MB");
        }
        section.figures["crowds"].push_back(one);
        section.goals.push_back({"scale: modes mixed at most over the budget, " + name,
                                 static_cast<double>(budgeted.modesMost) / scaled.modeBudget,
                                 BenchGoal::Kind::atMost, 1.05});
    }
    section.goals.push_back({"scale: cost with the budget over without, 1000 bodies",
                             withBudget[1000].meanFrameSeconds / without[1000].meanFrameSeconds,
                             BenchGoal::Kind::atMost, 0.25});
    section.goals.push_back({"scale: cost at 1000 bodies over 100, same budget",
                             withBudget[1000].meanFrameSeconds / withBudget[100].meanFrameSeconds,
                             BenchGoal::Kind::atMost, 2});
    return section;
}

} // namespace idiophone
