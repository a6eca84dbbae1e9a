// Simulates a scene into a recording, cell by cell, and collects figures.
#pragma once

#include "Console/MidiSong.h"
#include "Console/Recording.h"
#include "Console/StemFiles.h"
#include "Scene/SceneRenderer.h"
#include "World/HeadResponses.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace idiophone {

/// The figures of a hundredth of a second, the time step of the paper's bodies.
struct FrameFigures {
    std::int64_t bodies = 0;
    std::int64_t impacts = 0;      ///< one for each body of a collision
    std::int64_t modesMixed = 0;   ///< at the frame's last cell
    std::int64_t modesDropped = 0; ///< at its last cell: above tau, beyond the budget
};

struct SceneTally {
    std::vector<FrameFigures> frames;
    std::vector<SceneImpact> impacts; ///< struck impacts, in order of time
    std::int64_t notesLeftOut = 0;    ///< notes without a target
    std::int64_t impactsLeftOut = 0;  ///< impacts whose figures are not finite
    double soundSeconds = 0;          ///< measured, like motionSeconds
    double motionSeconds = 0;
    nlohmann::ordered_json stems; ///< figures of each stem's file
};

/// How a scene is rendered.
struct SceneRenderSettings {
    std::shared_ptr<const HeadResponses> head; ///< at the recording's sample rate; null: a sphere
    ParameterValues parameters;
    unsigned threads = 0; ///< 0: one on each core; the result does not depend on them
    SceneStems stems = SceneStems::none;
    std::filesystem::path stemFolder; ///< exists if there are stems
};

inline constexpr double sceneFrameSeconds = 0.01;

/// Renders up to the recording's length, or else to silence after everything has ended.
Result<SceneTally> renderScene(const std::shared_ptr<const SceneAssets>& assets,
                               std::span<const SongEvent> song,
                               const SceneRenderSettings& settings,
                               Recording& recording);

} // namespace idiophone
