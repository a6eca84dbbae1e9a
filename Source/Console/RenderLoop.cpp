#include "Console/RenderLoop.h"

#include "Console/Interrupt.h"
#include "Console/ProgressLine.h"

#include <algorithm>
#include <cmath>
#include <juce_audio_basics/juce_audio_basics.h>

namespace idiophone {
namespace {

constexpr double longestTailSeconds = 30;

} // namespace

Result<void> renderTo(Recording& recording, const RenderTask& task) {
    const juce::ScopedNoDenormals asInTheAudioCallback;
    const auto& interrupted = interruptRequested();
    const double rate = recording.format.sampleRateHz;
    const auto& seconds = recording.format.seconds;
    const std::int64_t end = seconds ? std::llround(*seconds * rate)
                                     : task.lastSample + std::llround(longestTailSeconds * rate);
    ProgressLine progress(task.name);
    for (std::int64_t position = 0; position < end;) {
        const auto piece = task.render(std::min(task.pieceSamples, end - position));
        if (!piece)
            return tl::unexpected(piece.error());
        if (auto done = recording.addAll(piece->left, piece->right); !done)
            return done;
        if (interrupted)
            return failure(std::string(interruptedMessage));
        position += static_cast<std::int64_t>(piece->size());
        if (!seconds && position > task.lastSample && task.finished() && recording.silent())
            break;
        progress.show(static_cast<double>(position) / static_cast<double>(end), "");
    }
    return recording.finish(seconds ? end : task.lastSample + 1);
}

} // namespace idiophone
