// The common loop of all renderings to a file: length, end, progress and Ctrl-C.
#pragma once

#include "Console/Recording.h"
#include "Instrument/StereoSpan.h"

#include <cstdint>
#include <functional>
#include <string>

namespace idiophone {

struct RenderTask {
    std::string name;            ///< for the progress line
    std::int64_t lastSample = 0; ///< of the last event, -1 without any
    std::int64_t pieceSamples = 0;
    /// Renders at most `count` samples and at most one piece. It may render fewer. The result is
    /// valid until the next call. An error ends the rendering.
    std::function<Result<StereoSpan>(std::int64_t count)> render;
    /// Returns true if nothing sounds any more or will sound without new events.
    std::function<bool()> finished;
};

/// Renders up to the recording's length, or else to silence after the last event, at most half a
/// minute later. Denormals are flushed, as in a host's callback.
Result<void> renderTo(Recording& recording, const RenderTask& task);

} // namespace idiophone
