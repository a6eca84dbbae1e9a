#include "Console/SceneRender.h"

#include "Console/RenderLoop.h"
#include "Instrument/Instrument.h"
#include "Instrument/SettingsOfParameters.h"
#include "Object/OneLine.h"
#include "Scene/SceneSound.h"

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
class ScenePerformance {
public:
    ScenePerformance(SceneSimulation& moved,
                     const SceneAssets& assets,
                     const std::shared_ptr<const HeadResponses>& head,
                     const ParameterValues& parameters,
                     double sampleRateHz)
        : motion(moved), sound(assets, motion.slots(), sampleRateHz, assets.scene().seed, head) {
        sound.setSettings(synthesisSettings(parameters));
        tally.notesLeftOut = motion.notesLeftOut();
    }

    /// Returns the next cell. The result is valid until the next call.
    StereoSpan next() {
        const CellOutput cell(left, right);
        const auto start = std::chrono::steady_clock::now();
        motion.advanceTo(sound.nextCellEndSeconds());
        const auto moved = std::chrono::steady_clock::now();
        sound.beginCell();
        while (const auto impact = motion.takeImpact(sound.cellEndSeconds())) {
            if (sound.strike(*impact))
                tally.impacts.push_back(*impact);
            else
                ++tally.impactsLeftOut;
        }
        sound.touch(motion.touches());
        sound.finishCell(motion.places(), cell);
        const auto sounded = std::chrono::steady_clock::now();
        tally.motionSeconds += std::chrono::duration<double>(moved - start).count();
        tally.soundSeconds += std::chrono::duration<double>(sounded - moved).count();
        count();
        return {left, right};
    }

    bool finished() const { return motion.finished() && sound.silent(); }
    bool isCrowded() const { return motion.isCrowded(); }
    SceneTally tally;

private:
    void count() {
        const auto frame = static_cast<std::size_t>(sound.cellStartSeconds() / sceneFrameSeconds);
        tally.frames.resize(frame + 1);
        auto& now = tally.frames.back();
        now.bodies = motion.figures().bodies;
        now.impacts += motion.figures().impacts - impactsBefore;
        impactsBefore = motion.figures().impacts;
        now.modesMixed = now.modesDropped = 0;
        for (const auto& slot : sound.synthesiser().status()) {
            now.modesMixed += slot.modesMixed;
            now.modesDropped += std::max(slot.modesRinging - slot.modesMixed, 0);
        }
    }

    SceneSimulation& motion;
    SceneSound sound;
    alignas(64) std::array<float, cellSamples> left{}, right{};
    std::int64_t impactsBefore = 0;
};

} // namespace

Result<SceneTally> renderScene(const std::shared_ptr<const SceneAssets>& assets,
                               const std::shared_ptr<const HeadResponses>& head,
                               std::span<const SongEvent> song,
                               const ParameterValues& parameters,
                               const RecordingFormat& format,
                               Recording& recording) {
    const double rate = format.sampleRateHz;
    const double lastSeconds =
        std::max(assets->scene().seconds, song.empty() ? 0 : song.back().seconds);
    SceneSimulation motion(assets, {.notes = notesOf(song)});
    if (auto bounded = boundedSlots(motion.slots(), inQuotes(assets->scene().name), "bodies");
        !bounded)
        return tl::unexpected(bounded.error());
    ScenePerformance performance(motion, *assets, head, parameters, rate);
    if (auto done = renderTo(recording, format,
                             {.name = assets->scene().name,
                              .lastSample = std::llround(std::ceil(lastSeconds * rate)) - 1,
                              .pieceSamples = cellSamples,
                              .render = [&](std::int64_t count) -> Result<StereoSpan> {
                                  const auto cell = performance.next();
                                  if (performance.isCrowded())
                                      return tl::unexpected(crowdedFault(assets->scene()));
                                  return cell.subspan(0, static_cast<std::size_t>(count));
                              },
                              .finished = [&] { return performance.finished(); }});
        !done)
        return tl::unexpected(done.error());
    return std::move(performance.tally);
}

} // namespace idiophone
