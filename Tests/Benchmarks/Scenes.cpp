#include "Benchmarks/Benchmarks.h"
#include "Benchmarks/Timer.h"
#include "Instrument/ObjectLibrary.h"
#include "Scene/FactoryScenes.h"
#include "Scene/SceneSimulation.h"

#include <algorithm>
#include <memory>

namespace idiophone {
namespace {

constexpr int replays = 3;
constexpr double longestSeconds = 10;
constexpr double tenthSeconds = 0.1;

/// Returns eight notes a second on all bars in turn, for a scene that notes set in motion.
std::vector<SceneNote> notesFor(const SceneAssets& assets) {
    std::vector<SceneNote> notes;
    if (assets.scene().noteDrop)
        for (int note = 0; notes.size() < 8 * longestSeconds; note = (note + 1) % 128)
            if (assets.target(note))
                notes.push_back({.seconds = static_cast<double>(notes.size()) / 8,
                                 .note = note,
                                 .velocity = 100});
    return notes;
}

/// Returns the largest time of a tenth of a second, in units of a tenth of a second.
double slowestTenth(const CellTimes& times) {
    const auto cells = cellsIn(tenthSeconds);
    double slowest = 0;
    for (std::size_t first = 0; first + cells <= times.seconds.size(); first += cells)
        slowest = std::max(slowest, times.sum(first, first + cells));
    return slowest / tenthSeconds;
}

} // namespace

Result<BenchSection> benchScenes(const BenchContent&) {
    BenchSection section{.name = "scenes",
                         .title = "time to move the bodies of the factory scenes, over real time"};
    for (const Scene& scene : factoryScenes()) {
        const auto assets = SceneAssets::make(scene, ObjectLibrary::shared());
        if (!assets)
            return tl::unexpected(assets.error());
        const double seconds = std::min(scene.seconds, longestSeconds);
        const SimulationSetup setup{.notes = notesFor(**assets)};
        std::unique_ptr<SceneSimulation> motion;
        const Replay replay{[&] { motion = std::make_unique<SceneSimulation>(*assets, setup); },
                            [&](std::size_t cell) {
                                motion->advanceTo(static_cast<double>(cell + 1) * cellSeconds);
                            }};
        const auto times = replayInTurn(std::span(&replay, 1), cellsIn(seconds), replays).front();
        const double mean = times.sum() / seconds, slowest = slowestTenth(times);
        section.row(scene.name, figure(mean) + " of real time, " + figure(slowest) +
                                    " in the slowest tenth of a second; " +
                                    std::to_string(motion->figures().impacts) + " impacts in " +
                                    figure(seconds) + " s");
        section.figures["scenes"].push_back({{"name", scene.name},
                                             {"seconds", seconds},
                                             {"motion_over_real_time", mean},
                                             {"slowest_tenth_over_real_time", slowest},
                                             {"impacts", motion->figures().impacts}});
        const std::string name = scene.name == "A hundred rings" ? "100 rings" : scene.name;
        section.goals.push_back(
            {"scenes: motion over real time, " + name, mean, BenchGoal::Kind::atMost, 0.5});
    }
    return section;
}

} // namespace idiophone
