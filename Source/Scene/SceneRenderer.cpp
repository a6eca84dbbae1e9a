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

/// The stems of contacts: impacts, slides and rolls.
constexpr std::size_t contactKinds = 3;

/// Returns the slots that sound: for stems of contacts each body once for each kind.
std::vector<SynthesiserSlot> soundingSlots(const SceneSimulation& motion, SceneStems stems) {
    auto slots = motion.slots();
    for (std::size_t kind = 1; stems == SceneStems::contacts && kind < contactKinds; ++kind)
        slots.insert(slots.end(), motion.slots().begin(), motion.slots().end());
    return slots;
}

} // namespace

SceneRenderer::SceneRenderer(SceneSimulation& simulation,
                             const SceneAssets& assets,
                             const std::shared_ptr<const HeadResponses>& head,
                             const ParameterValues& parameters,
                             double sampleRateHz,
                             WorkTeam& sharingTeam,
                             SceneStems stems)
    : team(sharingTeam), motion(simulation), stemKind(stems), slotsOfBodies(motion.slots().size()),
      synth(soundingSlots(motion, stems), sampleRateHz, 1), sound(synth.slotCount(),
                                                                  assets.surfaces(),
                                                                  assets.scene().listener,
                                                                  sampleRateHz,
                                                                  assets.scene().seed,
                                                                  head),
      samples(synth.slotCount() * cellSamples), outputs(cellsOfSlotsIn(samples)),
      cellSeconds(cellSamples / sampleRateHz) {
    synth.setSettings(synthesisSettings(parameters));
    if (stems == SceneStems::none)
        return;
    const std::size_t stemCount = stems == SceneStems::bodies ? slotsOfBodies : contactKinds;
    stemSamples.resize(stemCount * 2 * cellSamples);
    for (std::size_t stem = 0; stem < stemCount; ++stem) {
        const auto both = std::span(stemSamples).subspan(stem * 2 * cellSamples, 2 * cellSamples);
        stemSpans.push_back({both.first<cellSamples>(), both.last<cellSamples>()});
    }
    for (std::size_t slot = 0; slot < synth.slotCount(); ++slot) {
        const auto& ears = stemSpans[stems == SceneStems::bodies ? slot : slot / slotsOfBodies];
        earsOfSlots.emplace_back(ears.left.first<cellSamples>(), ears.right.first<cellSamples>());
    }
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
        return !sound.strike(impact.slot, impact.strike, sample, begun);
    }));
    if (stemKind == SceneStems::contacts)
        for (auto& touch : cell.touches)
            for (auto& slot : touch.slots)
                if (slot < slotsOfBodies)
                    slot += slotsOfBodies;
    const std::size_t rollSlots = stemKind == SceneStems::contacts ? slotsOfBodies : 0;
    for (std::size_t voice = 0; voice < cell.touches.size(); ++voice)
        sound.contacts.press(voice, cell.touches[voice], begun, rollSlots);
    sound.crowded.strikeBefore(cellSamples, begun);
    if (stemKind == SceneStems::none)
        return sound.hear(outputs, cell.places, {left, right});
    std::ranges::fill(stemSamples, 0.0f);
    sound.hearApart(outputs, cell.places, earsOfSlots);
    mixStems();
}

void SceneRenderer::mixStems() {
    left.fill(0);
    right.fill(0);
    for (const auto& stem : stemSpans)
        for (std::size_t i = 0; i < cellSamples; ++i) {
            left[i] += stem.left[i];
            right[i] += stem.right[i];
        }
}

} // namespace idiophone
