#include "Console/SongRender.h"

#include "Console/RenderLoop.h"
#include "Instrument/MidiControllers.h"

#include <algorithm>
#include <chrono>
#include <cmath>

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
                               Recording& recording,
                               const std::string& task) {
    const auto& format = recording.format;
    const double rate = format.sampleRateHz;
    const std::int64_t lastEvent = events.empty() ? -1 : sampleOf(events.back(), rate);
    player.setOffline(true);
    RenderTally tally;
    for (const auto& event : events)
        if (event.isNoteOn() && (!format.seconds || event.seconds < *format.seconds))
            ++(player.instrument().key(event.bytes[1]).slot >= 0 ? tally.strikes
                                                                 : tally.notesWithoutKey);

    const auto blockSize = static_cast<std::size_t>(format.blockSize);
    std::vector<float> left(blockSize), right(blockSize);
    std::vector<MidiEvent> due;
    std::size_t next = 0;
    std::int64_t position = 0, lastCell = -1;
    const auto block = [&](std::int64_t count) {
        due.clear();
        for (; next < events.size() && sampleOf(events[next], rate) < position + count; ++next) {
            if (const auto sample = sampleOf(events[next], rate);
                sample > position && midi::isAllSoundOff(events[next].bytes)) {
                count = sample - position; // the room is silenced from this event on
                break;
            }
            due.push_back(
                {.sampleOffset = static_cast<int>(sampleOf(events[next], rate) - position),
                 .bytes = events[next].bytes});
        }
        const auto span = StereoSpan{left, right}.subspan(0, static_cast<std::size_t>(count));
        const auto start = std::chrono::steady_clock::now();
        player.process(span, due, parameters);
        tally.renderSeconds +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        position += count;
        if (const auto silenced = player.takeSilenced())
            recording.hush(*silenced);
        if (const auto cell = (position - 1) / cellSamples; cell != lastCell) {
            tally.count(player.synthesiser().modesMixed());
            lastCell = cell;
        }
        return span;
    };
    return renderTo(recording, {.name = task,
                                .lastSample = lastEvent,
                                .pieceSamples = format.blockSize,
                                .render = block,
                                .finished = [&] { return player.silent(); }})
        .map([&] { return tally; });
}

} // namespace idiophone
