#include "Console/SceneRender.h"

#include "Console/RenderLoop.h"
#include "Instrument/Instrument.h"
#include "Object/FileName.h"
#include "Object/OneLine.h"
#include "Object/WorkTeam.h"

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

/// Returns the name of a body's file: its number, and its kind or its object.
std::string nameOfBody(const SceneAssets& assets, const SceneSimulation& motion, std::size_t slot) {
    const auto role = motion.roleOf(slot);
    const auto& kinds = assets.scene().kinds;
    return fileNameFrom(std::to_string(slot + 1) + "-" +
                        (role < kinds.size() ? kinds[role].name : assets.roles()[role].object));
}

std::vector<std::string>
namesOfStems(const SceneAssets& assets, const SceneSimulation& motion, SceneStems stems) {
    if (stems == SceneStems::contacts)
        return {"impacts", "slides", "rolls"};
    std::vector<std::string> names;
    for (std::size_t slot = 0; stems == SceneStems::bodies && slot < motion.slots().size(); ++slot)
        names.push_back(nameOfBody(assets, motion, slot));
    return names;
}

} // namespace

Result<SceneTally> renderScene(const std::shared_ptr<const SceneAssets>& assets,
                               std::span<const SongEvent> song,
                               const SceneRenderSettings& settings,
                               Recording& recording) {
    const double rate = recording.format.sampleRateHz;
    const double lastSeconds =
        std::max(assets->scene().seconds, song.empty() ? 0 : song.back().seconds);
    WorkTeam team(settings.threads);
    SceneSimulation motion(assets, {.notes = notesOf(song), .team = &team});
    if (auto bounded = boundedSlots(motion.slots(), inQuotes(assets->scene().name), "bodies");
        !bounded)
        return tl::unexpected(bounded.error());
    SceneRenderer renderer(motion, *assets, settings.head, settings.parameters, rate, team,
                           settings.stems);
    StemFiles stems(settings.stemFolder, namesOfStems(*assets, motion, settings.stems),
                    recording.format, settings.parameters);
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
        if (auto added = stems.add(renderer.stems(), static_cast<std::size_t>(count)); !added)
            return tl::unexpected(added.error());
        return cell.subspan(0, static_cast<std::size_t>(count));
    };
    return renderTo(recording, {.name = assets->scene().name,
                                .lastSample = std::llround(std::ceil(lastSeconds * rate)) - 1,
                                .pieceSamples = cellSamples,
                                .render = nextCell,
                                .finished = [&] { return renderer.finished(); }})
        .and_then([&] { return stems.finish(recording.statistics()["samples"]); })
        .map([&] {
            tally.stems = stems.statistics();
            tally.impactsLeftOut = renderer.impactsLeftOut();
            tally.soundSeconds = renderer.soundSeconds();
            tally.motionSeconds = renderer.motionSeconds();
            return std::move(tally);
        });
}

} // namespace idiophone
