#include "Benchmarks/Benchmarks.h"
#include "Benchmarks/Timer.h"
#include "Instrument/ObjectLibrary.h"
#include "Object/WorkTeam.h"
#include "Scene/FactoryScenes.h"
#include "Scene/SceneRenderer.h"

#include <algorithm>
#include <memory>
#include <thread>

namespace idiophone {
namespace {

constexpr int replays = 8;
constexpr std::size_t cellsOfFrame = 7; // 10.2 ms

/// The hundred rings, as `idiophone scene` moves and sounds them.
class RenderedRings {
public:
    RenderedRings(std::shared_ptr<const SceneAssets> scene, unsigned threads)
        : assets(std::move(scene)), team(threads) {}

    void restart() {
        renderer.reset();
        motion = std::make_unique<SceneSimulation>(assets, SimulationSetup{.team = &team});
        renderer = std::make_unique<SceneRenderer>(
            *motion, *assets, nullptr, assets->scene().parameters, benchSampleRateHz, team);
        sound.clear();
    }

    void render() {
        const auto cell = renderer->next();
        sound.insert(sound.end(), cell.left.begin(), cell.left.end());
        sound.insert(sound.end(), cell.right.begin(), cell.right.end());
    }

    std::vector<float> sound; ///< cell by cell, left then right

private:
    std::shared_ptr<const SceneAssets> assets;
    WorkTeam team;
    std::unique_ptr<SceneSimulation> motion;
    std::unique_ptr<SceneRenderer> renderer;
};

/// Returns audio frames of 1/100 s per second of computing, averaged over about a frame.
std::vector<double> framesPerSecond(const CellTimes& times) {
    std::vector<double> rates;
    for (std::size_t cell = 0; cell + cellsOfFrame <= times.seconds.size(); cell += cellsOfFrame)
        rates.push_back(100 * cellSeconds * cellsOfFrame / times.sum(cell, cell + cellsOfFrame));
    return rates;
}

} // namespace

Result<BenchSection> benchRender(const BenchContent&) {
    const auto assets =
        SceneAssets::make(*findFactoryScene("A hundred rings"), ObjectLibrary::shared());
    if (!assets)
        return tl::unexpected(assets.error());
    const double seconds = (*assets)->scene().seconds;
    RenderedRings one(*assets, 1), two(*assets, 2);
    const auto replay = [](RenderedRings& rings) {
        return Replay{[&] { rings.restart(); }, [&](std::size_t) { rings.render(); }};
    };
    const auto times =
        replayInTurn(std::array{replay(one), replay(two)}, cellsIn(seconds), replays);
    std::size_t differing = 0;
    for (std::size_t k = 0; k < one.sound.size(); ++k)
        differing += one.sound[k] != two.sound[k] ? 1 : 0;

    BenchSection section{.name = "render",
                         .title = "motion and sound of the scene A hundred rings, " +
                                  figure(seconds) + " s, with one thread and with two, on " +
                                  std::to_string(std::thread::hardware_concurrency()) + " cores"};
    const double ratio = times[0].sum() / times[1].sum();
    for (std::size_t k = 0; k < times.size(); ++k) {
        const double rate = 100 * seconds / times[k].sum();
        const std::string name = k == 0 ? "one core" : "two cores";
        section.row(name, figure(rate) + " audio frames a second, " +
                              figure(times[k].sum() / seconds) + " of real time");
        section.figures["curves"].push_back({{"name", name},
                                             {"frame_seconds", cellSeconds * cellsOfFrame},
                                             {"frames_per_second", framesPerSecond(times[k])},
                                             {"mean_frames_per_second", rate}});
    }
    section.figures["seconds"] = seconds;
    section.figures["two_cores_over_one"] = ratio;
    section.figures["samples"] = one.sound.size();
    section.figures["differing_samples"] = differing;
    section.goals.push_back({"render: two cores over one", ratio, BenchGoal::Kind::atLeast, 1.7});
    section.goals.push_back({"render: samples that differ between two cores and one",
                             static_cast<double>(differing), BenchGoal::Kind::atMost, 0});
    return section;
}

} // namespace idiophone
