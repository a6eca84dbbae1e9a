#include "Console/SongRender.h"

#include "Console/Interrupt.h"
#include "Console/ProgressLine.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <juce_audio_basics/juce_audio_basics.h>

namespace idiophone {
namespace {

std::int64_t sampleOf(const SongEvent& event, double sampleRateHz) {
    return std::llround(event.seconds * sampleRateHz);
}

} // namespace

void RenderTally::count(std::int64_t modesMixed) {
    ++cells;
    modesMixedMean +=
        (static_cast<double>(modesMixed) - modesMixedMean) / static_cast<double>(cells);
    modesMixedMost = std::max(modesMixedMost, modesMixed);
}

Result<RenderTally> renderSong(Player& player,
                               std::span<const SongEvent> events,
                               const ParameterValues& parameters,
                               const RecordingFormat& format,
                               Recording& recording,
                               const std::string& task) {
    const juce::ScopedNoDenormals asInTheAudioCallback;
    const auto& interrupted = interruptRequested();
    const double rate = format.sampleRateHz;
    const std::int64_t lastEvent = events.empty() ? -1 : sampleOf(events.back(), rate);
    const std::int64_t end = format.seconds ? std::llround(*format.seconds * rate)
                                            : lastEvent + std::llround(longestTailSeconds * rate);
    const auto sounds = [&](const SongEvent& event) {
        return event.isNoteOn() && player.instrument().key(event.bytes[1]).slot >= 0 &&
               sampleOf(event, rate) < end;
    };
    RenderTally tally;
    tally.strikes = std::ranges::count_if(events, sounds);

    ProgressLine progress(task);
    const auto blockSize = static_cast<std::size_t>(format.blockSize);
    std::vector<float> left(blockSize), right(blockSize);
    std::vector<MidiEvent> due;
    std::size_t next = 0;
    std::int64_t lastCell = -1;
    for (std::int64_t position = 0; position < end; position += format.blockSize) {
        const auto count = std::min<std::int64_t>(format.blockSize, end - position);
        due.clear();
        for (; next < events.size() && sampleOf(events[next], rate) < position + count; ++next)
            due.push_back(
                {.sampleOffset = static_cast<int>(sampleOf(events[next], rate) - position),
                 .bytes = events[next].bytes});
        const auto block = StereoSpan{left, right}.subspan(0, static_cast<std::size_t>(count));

        const auto start = std::chrono::steady_clock::now();
        player.process(block, due, parameters);
        tally.renderSeconds +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

        if (const auto cell = (position + count - 1) / cellSamples; cell != lastCell) {
            tally.count(player.synthesiser().modesMixed());
            lastCell = cell;
        }
        if (auto done = recording.add(block.left, block.right); !done)
            return tl::unexpected(done.error());
        if (interrupted)
            return failure(std::string(interruptedMessage));
        if (!format.seconds && position + count > lastEvent && player.silent())
            break;
        progress.show(static_cast<double>(position) / static_cast<double>(end), "");
    }
    if (auto done = recording.finish(format.seconds ? end : lastEvent + 1); !done)
        return tl::unexpected(done.error());
    return tally;
}

} // namespace idiophone
