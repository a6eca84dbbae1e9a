#include "Scene/SceneRenderer.h"

#include "Instrument/SettingsOfParameters.h"
#include "Object/WorkTeam.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace idiophone {
namespace {

/// Adds the time of its scope to a sum in seconds.
class StopWatch {
public:
    explicit StopWatch(double& seconds) : sum(seconds) {}
    ~StopWatch() { sum += std::chrono::duration<double>(Clock::now() - start).count(); }
    StopWatch(const StopWatch&) = delete;
    StopWatch& operator=(const StopWatch&) = delete;

private:
    using Clock = std::chrono::steady_clock;
    double& sum;
    Clock::time_point start = Clock::now();
};

} // namespace

SceneRenderer::SceneRenderer(SceneSimulation& simulation,
                             const SceneAssets& assets,
                             const std::shared_ptr<const HeadResponses>& head,
                             const ParameterValues& parameters,
                             double sampleRateHz,
                             WorkTeam& sharingTeam)
    : team(sharingTeam), motion(simulation), synth(motion.slots(), sampleRateHz, 1),
      sound(assets, synth.slotCount(), sampleRateHz, assets.scene().seed, head),
      samples(synth.slotCount() * cellSamples), outputs(cellsOfSlotsIn(samples)),
      cellSeconds(cellSamples / sampleRateHz) {
    synth.setSettings(synthesisSettings(parameters));
}

StereoSpan SceneRenderer::next() {
    if (cellsMoved == 0)
        move();
    std::swap(cell, nextCell);
    team.runBoth([this] { soundCell(); }, [this] { move(); });
    return {left, right};
}

void SceneRenderer::move() {
    const StopWatch watch(timeOfMotion);
    motion.advanceTo(startSeconds(cellsMoved - 1) + 2 * cellSeconds);
    nextCell.impacts.clear();
    while (const auto impact = motion.takeImpact(startSeconds(cellsMoved) + cellSeconds))
        nextCell.impacts.push_back(*impact);
    ++cellsMoved;
    std::ranges::copy(motion.touches(), nextCell.touches.begin());
    nextCell.places.assign(motion.places().begin(), motion.places().end());
    nextCell.figures = motion.figures();
    nextCell.isFinished = motion.finished();
    nextCell.isCrowded = motion.isCrowded();
}

void SceneRenderer::soundCell() {
    const StopWatch watch(timeOfSound);
    const BegunCell begun{synth, outputs, cellsSounded++};
    synth.beginCell(outputs);
    leftOut += static_cast<std::int64_t>(std::erase_if(cell.impacts, [&](const auto& impact) {
        const double sample = (impact.seconds - startSeconds(begun.index)) * synth.sampleRateHz();
        return !sound.strike(impact, sample, begun);
    }));
    for (std::size_t voice = 0; voice < cell.touches.size(); ++voice)
        sound.contacts.press(voice, cell.touches[voice], begun);
    sound.crowded.strikeBefore(cellSamples, begun);
    sound.hear(outputs, cell.places, {left, right});
}

} // namespace idiophone
