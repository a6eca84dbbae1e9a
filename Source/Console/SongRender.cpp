#include "Console/SongRender.h"

#include "Console/RenderLoop.h"
#include "Instrument/MidiControllers.h"
#include "Instrument/MidiTuning.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace idiophone {
namespace {

template <class Event>
std::int64_t sampleOf(const Event& event, double sampleRateHz) {
    return std::llround(event.seconds * sampleRateHz);
}

/// Tunes a player by the messages of a song. They have to begin a block.
class SongTuner {
public:
    SongTuner(Player& player, std::span<const SongTuning> tunings, double sampleRateHz)
        : tuned(player), rest(tunings), rate(sampleRateHz) {}

    /// Follows the messages up to a sample. Returns the samples from there to the next message, at
    /// most `count`.
    std::int64_t follow(std::int64_t position, std::int64_t count) {
        bool isRetuned = false;
        for (; !rest.empty() && sampleOf(rest.front(), rate) <= position; rest = rest.subspan(1))
            isRetuned |= messages.read(rest.front().message);
        if (isRetuned)
            tuned.setTuning(messages.keys());
        return rest.empty() ? count : std::min(count, sampleOf(rest.front(), rate) - position);
    }

private:
    Player& tuned;
    std::span<const SongTuning> rest;
    double rate;
    MidiTuning messages;
};

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
                               const std::string& task,
                               std::span<const SongTuning> tunings) {
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
    SongTuner tuner(player, tunings, rate);
    const auto block = [&](std::int64_t longest) {
        auto count = tuner.follow(position, longest);
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
