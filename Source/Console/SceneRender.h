// Performs a scene into a recording, cell by cell, and keeps figures of it.
#pragma once

#include "Console/MidiSong.h"
#include "Console/Recording.h"
#include "Scene/HeadResponses.h"
#include "Scene/SceneRun.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace idiophone {

/// Of a hundredth of a second, in which the paper moves its bodies once.
struct FrameFigures {
    std::int64_t bodies = 0;
    std::int64_t impacts = 0;      ///< sides of blows
    std::int64_t modesMixed = 0;   ///< at its last cell
    std::int64_t modesDropped = 0; ///< at its last cell: ringing above tau, beyond the budget
};

struct SceneTally {
    std::vector<FrameFigures> frames;
    std::vector<SceneBlow> blows;  ///< those that were struck, in order of time
    std::int64_t notesLeftOut = 0; ///< that hit nothing
    std::int64_t blowsLeftOut = 0; ///< whose figures are not finite
    double soundSeconds = 0;       ///< measured, as the next
    double motionSeconds = 0;
};

inline constexpr double sceneFrameSeconds = 0.01;

/// Renders up to the length of the format, or else to silence after all has come to an end. `head`:
/// the listener's, measured, at the format's rate; none: a sphere.
Result<SceneTally> renderScene(const std::shared_ptr<const SceneCast>& cast,
                               const std::shared_ptr<const HeadResponses>& head,
                               std::span<const SongEvent> song,
                               const ParameterValues& parameters,
                               const RecordingFormat& format,
                               Recording& recording);

} // namespace idiophone
