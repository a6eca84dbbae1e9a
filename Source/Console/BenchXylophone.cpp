#include "Console/BenchTimer.h"
#include "Console/Benchmarks.h"

#include <algorithm>
#include <benchmark/benchmark.h>

namespace idiophone {

Result<BenchSection> benchXylophone(const BenchContent& content) {
    if (content.song.empty())
        return failure("The xylophone benchmark plays a song: name it with --song FILE.mid.");
    constexpr int replays = 5;
    constexpr double tailSeconds = 1;
    const double songSeconds = content.song.back().seconds + tailSeconds;
    const std::size_t cells = cellsIn(songSeconds);
    BenchScene scene(content.songSlots, content.song, content.songSettings);
    LeastStepTimes times;
    std::int64_t most = 0;
    double modeCells = 0;
    const std::vector<Contestant> contestants{[&] {
        scene.restart();
        times.replay(cells, [&](std::size_t) { benchmark::DoNotOptimize(scene.nextCell()); });
    }};
    callInTurn(contestants, replays);
    scene.restart();
    for (std::size_t k = 0; k < cells; ++k) {
        scene.nextCell();
        const std::int64_t modes = scene.synthesiser().modesMixed();
        most = std::max(most, modes);
        modeCells += static_cast<double>(modes);
    }

    const double share = times.sum() / songSeconds;
    const double worst = *std::max_element(times.seconds().begin(), times.seconds().end());
    BenchSection section{.name = "xylophone",
                         .title = content.songName + ": " + std::to_string(content.song.size()) +
                                  " strikes in " + figure(songSeconds) +
                                  " s on the rosewood xylophone"};
    section.row("share of one core", figure(100 * share) + " %");
    section.row("dearest cell",
                figure(100 * worst * benchSampleRateHz / cellSamples) + " % of its own length");
    section.row("modes mixed", figure(modeCells / static_cast<double>(cells)) + " on average, " +
                                   std::to_string(most) + " at most");
    section.figures["share_of_core"] = share;
    section.figures["dearest_cell_share"] = worst * benchSampleRateHz / cellSamples;
    section.figures["modes_mixed_mean"] = modeCells / static_cast<double>(cells);
    section.figures["modes_mixed_most"] = most;
    section.figures["strikes"] = content.song.size();
    section.figures["seconds"] = songSeconds;
    return section;
}

} // namespace idiophone
