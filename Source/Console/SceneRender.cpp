#include "Console/SceneRender.h"

#include "Console/RenderLoop.h"
#include "Instrument/Instrument.h"
#include "Object/OneLine.h"
#include "Object/WorkTeam.h"
#include "Scene/SceneRenderer.h"

#include <algorithm>
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

/// Adds the newest cell of a renderer, which begins at `seconds`.
void addCell(SceneTally& tally,
             const SceneRenderer& renderer,
             double seconds,
             std::int64_t impactsBefore) {
    tally.frames.resize(static_cast<std::size_t>(seconds / sceneFrameSeconds) + 1);
    auto& frame = tally.frames.back();
    frame.bodies = renderer.figures().bodies;
    frame.impacts += renderer.figures().impacts - impactsBefore;
    frame.modesMixed = frame.modesDropped = 0;
    for (const auto& slot : renderer.status()) {
        frame.modesMixed += slot.modesMixed;
        frame.modesDropped += std::max(slot.modesRinging - slot.modesMixed, 0);
    }
    tally.impacts.insert(tally.impacts.end(), renderer.impacts().begin(), renderer.impacts().end());
}

} // namespace

Result<SceneTally> renderScene(const std::shared_ptr<const SceneAssets>& assets,
                               const std::shared_ptr<const HeadResponses>& head,
                               std::span<const SongEvent> song,
                               const ParameterValues& parameters,
                               unsigned threads,
                               Recording& recording) {
    const double rate = recording.format.sampleRateHz;
    const double lastSeconds =
        std::max(assets->scene().seconds, song.empty() ? 0 : song.back().seconds);
    WorkTeam team(threads);
    SceneSimulation motion(assets, {.notes = notesOf(song), .team = &team});
    if (auto bounded = boundedSlots(motion.slots(), inQuotes(assets->scene().name), "bodies");
        !bounded)
        return tl::unexpected(bounded.error());
    SceneRenderer renderer(motion, *assets, head, parameters, rate, team);
    SceneTally tally;
    tally.notesLeftOut = motion.notesLeftOut();
    std::int64_t cells = 0;
    const auto nextCell = [&](std::int64_t count) -> Result<StereoSpan> {
        const auto impactsBefore = renderer.figures().impacts;
        const auto cell = renderer.next();
        if (renderer.isCrowded())
            return tl::unexpected(crowdedFault(assets->scene()));
        const double cellSeconds = cellSamples / rate;
        addCell(tally, renderer, static_cast<double>(cells++) * cellSeconds, impactsBefore);
        return cell.subspan(0, static_cast<std::size_t>(count));
    };
    return renderTo(recording, {.name = assets->scene().name,
                                .lastSample = std::llround(std::ceil(lastSeconds * rate)) - 1,
                                .pieceSamples = cellSamples,
                                .render = nextCell,
                                .finished = [&] { return renderer.finished(); }})
        .map([&] {
            tally.impactsLeftOut = renderer.impactsLeftOut();
            tally.soundSeconds = renderer.soundSeconds();
            tally.motionSeconds = renderer.motionSeconds();
            return std::move(tally);
        });
}

} // namespace idiophone
