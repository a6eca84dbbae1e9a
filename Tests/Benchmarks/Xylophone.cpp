#include "Benchmarks/Benchmarks.h"
#include "Benchmarks/Timer.h"

#include <algorithm>
#include <array>

namespace idiophone {

Result<BenchSection> benchXylophone(const BenchContent& content) {
    if (content.song.empty())
        return failure("The xylophone benchmark plays a song: name it with --song FILE.mid.");
    constexpr int replays = 5;
    constexpr double tailSeconds = 1;
    const double songSeconds = content.song.back().seconds + tailSeconds;
    const std::size_t cells = cellsIn(songSeconds);
    BenchScene scene(content.songSlots, content.song, content.songSettings);
    const auto times = replayInTurn(std::array{replayOf(scene)}, cells, replays).front();
    const auto modes = scene.modesMixed(cells);
    const double mean = meanOf(modes);
    const std::int64_t most = std::ranges::max(modes);

    const double share = times.sum() / songSeconds;
    const double worst = std::ranges::max(times.seconds) / cellSeconds;
    BenchSection section{.name = "xylophone",
                         .title = content.songName + ": " + std::to_string(content.song.size()) +
                                  " strikes in " + figure(songSeconds) +
                                  " s on the rosewood xylophone"};
    section.row("share of one core", figure(100 * share) + " %");
    section.row("dearest cell", figure(100 * worst) + " % of its own length");
    section.row("modes mixed", figure(mean) + " on average, " + std::to_string(most) + " at most");
    section.figures["share_of_core"] = share;
    section.figures["dearest_cell_share"] = worst;
    section.figures["modes_mixed_mean"] = mean;
    section.figures["modes_mixed_most"] = most;
    section.figures["strikes"] = content.song.size();
    section.figures["seconds"] = songSeconds;
    return section;
}

} // namespace idiophone
