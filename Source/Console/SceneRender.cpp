#include "Console/SceneRender.h"

#include "Console/RenderLoop.h"
#include "Instrument/Instrument.h"
#include "Instrument/SettingsOfParameters.h"
#include "Object/OneLine.h"
#include "Scene/SceneSound.h"
#include "Synth/AlignedVector.h"

#include <chrono>
#include <cmath>

namespace idiophone {
namespace {

std::vector<SceneNote> notesOf(std::span<const SongEvent> song) {
    std::vector<SceneNote> notes;
    for (const auto& event : song)
        if (event.isNoteOn())
            notes.push_back({event.seconds, event.bytes[1], event.bytes[2]});
    return notes;
}

/// Simulates and renders a scene, one cell at a time.
class SceneRenderer {
public:
    SceneRenderer(SceneSimulation& moved,
                  const SceneAssets& assets,
                  const std::shared_ptr<const HeadResponses>& head,
                  const ParameterValues& parameters,
                  double sampleRateHz)
        : motion(moved), synth(motion.slots(), sampleRateHz, 1),
          sound(assets, synth.slotCount(), sampleRateHz, assets.scene().seed, head),
          samples(synth.slotCount() * cellSamples), cells(cellsOfSlotsIn(samples)),
          cellSeconds(cellSamples / sampleRateHz) {
        synth.setSettings(synthesisSettings(parameters));
        tally.notesLeftOut = motion.notesLeftOut();
    }

    /// Returns the next cell. The result is valid until the next call.
    StereoSpan next() {
        const auto start = std::chrono::steady_clock::now();
        motion.advanceTo(startSeconds + 2 * cellSeconds);
        const auto moved = std::chrono::steady_clock::now();
        const BegunCell cell{synth, cells, cellsBegun++};
        startSeconds = static_cast<double>(cell.index) * cellSeconds;
        synth.beginCell(cells);
        while (const auto impact = motion.takeImpact(startSeconds + cellSeconds)) {
            const double sample = (impact->seconds - startSeconds) * synth.sampleRateHz();
            if (sound.strike(*impact, sample, cell))
                tally.impacts.push_back(*impact);
            else
                ++tally.impactsLeftOut;
        }
        for (std::size_t voice = 0; voice < motion.touches().size(); ++voice)
            sound.contacts.press(voice, motion.touches()[voice], cell);
        sound.crowded.strikeBefore(cellSamples, cell);
        sound.hear(cells, motion.places(), {left, right});
        const auto sounded = std::chrono::steady_clock::now();
        tally.motionSeconds += std::chrono::duration<double>(moved - start).count();
        tally.soundSeconds += std::chrono::duration<double>(sounded - moved).count();
        count();
        return {left, right};
    }

    bool finished() const { return motion.finished() && synth.silent() && sound.silent(); }
    bool isCrowded() const { return motion.isCrowded(); }
    SceneTally tally;

private:
    void count() {
        const auto frame = static_cast<std::size_t>(startSeconds / sceneFrameSeconds);
        tally.frames.resize(frame + 1);
        auto& now = tally.frames.back();
        now.bodies = motion.figures().bodies;
        now.impacts += motion.figures().impacts - impactsBefore;
        impactsBefore = motion.figures().impacts;
        now.modesMixed = now.modesDropped = 0;
        for (const auto& slot : synth.status()) {
            now.modesMixed += slot.modesMixed;
            now.modesDropped += std::max(slot.modesRinging - slot.modesMixed, 0);
        }
    }

    SceneSimulation& motion;
    Synthesiser synth;
    SceneSound sound;
    AlignedVector<float> samples;  ///< [slots, 64]
    std::vector<CellOutput> cells; ///< views into `samples`
    double cellSeconds;
    double startSeconds = -cellSeconds; ///< of the newest cell
    std::int64_t cellsBegun = 0;
    alignas(64) std::array<float, cellSamples> left{}, right{};
    std::int64_t impactsBefore = 0;
};

} // namespace

Result<SceneTally> renderScene(const std::shared_ptr<const SceneAssets>& assets,
                               const std::shared_ptr<const HeadResponses>& head,
                               std::span<const SongEvent> song,
                               const ParameterValues& parameters,
                               Recording& recording) {
    const double rate = recording.format.sampleRateHz;
    const double lastSeconds =
        std::max(assets->scene().seconds, song.empty() ? 0 : song.back().seconds);
    SceneSimulation motion(assets, {.notes = notesOf(song)});
    if (auto bounded = boundedSlots(motion.slots(), inQuotes(assets->scene().name), "bodies");
        !bounded)
        return tl::unexpected(bounded.error());
    SceneRenderer renderer(motion, *assets, head, parameters, rate);
    return renderTo(recording, {.name = assets->scene().name,
                                .lastSample = std::llround(std::ceil(lastSeconds * rate)) - 1,
                                .pieceSamples = cellSamples,
                                .render = [&](std::int64_t count) -> Result<StereoSpan> {
                                    const auto cell = renderer.next();
                                    if (renderer.isCrowded())
                                        return tl::unexpected(crowdedFault(assets->scene()));
                                    return cell.subspan(0, static_cast<std::size_t>(count));
                                },
                                .finished = [&] { return renderer.finished(); }})
        .map([&] { return std::move(renderer.tally); });
}

} // namespace idiophone
