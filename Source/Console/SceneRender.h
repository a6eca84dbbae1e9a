// Simulates a scene into a recording, cell by cell, and collects figures.
#pragma once

#include "Console/MidiSong.h"
#include "Console/Recording.h"
#include "Scene/HeadResponses.h"
#include "Scene/SceneSimulation.h"

#include <cstdint>
#include <memory>
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
};

inline constexpr double sceneFrameSeconds = 0.01;

/// Renders up to the recording's length, or else to silence after everything has ended. `head`: the
/// listener's measured head at the recording's sample rate; null selects a sphere. `threads`: 0 for
/// one on each core; the result does not depend on them.
Result<SceneTally> renderScene(const std::shared_ptr<const SceneAssets>& assets,
                               const std::shared_ptr<const HeadResponses>& head,
                               std::span<const SongEvent> song,
                               const ParameterValues& parameters,
                               unsigned threads,
                               Recording& recording);

} // namespace idiophone
