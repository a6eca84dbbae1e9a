// What every rendering to a file has in common: its length, its end, progress and Ctrl-C.
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
    /// Renders so many samples, a piece's or fewer, or only the first of them; they are there until
    /// the next call. An error ends it all.
    std::function<Result<StereoSpan>(std::int64_t count)> render;
    /// Nothing sounds any more, nor will it by itself.
    std::function<bool()> finished;
};

/// Renders up to the length of the format, or else to silence after the last event, half a minute
/// later at the latest. Denormals are flushed, as in a host's callback.
Result<void> renderTo(Recording& recording, const RecordingFormat& format, const RenderTask& task);

} // namespace idiophone
