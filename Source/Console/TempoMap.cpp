#include "Console/TempoMap.h"

#include <algorithm>
#include <functional>

namespace idiophone {
namespace {

using Messages = std::vector<const juce::MidiMessage*>;

template <class Wanted>
void addAll(const MidiTracks& midi, Wanted isWanted, Messages& messages) {
    for (const auto& track : midi.tracks)
        for (const auto& message : track)
            if (isWanted(message))
                messages.push_back(&message);
}

/// Returns the rate of an SMPTE format. 29 stands for 30 frames with dropped numbers.
double framesPerSecond(int timeFormat) {
    const int rate = -(timeFormat >> 8);
    return rate == 29 ? 30000.0 / 1001 : rate;
}

} // namespace

// JUCE reads the three bytes of a tempo even if the event is shorter.
bool isTempo(const juce::MidiMessage& message) {
    return message.isTempoMetaEvent() && message.getMetaEventLength() >= 3;
}

TempoMap::TempoMap(const MidiTracks& midi) : timeFormat(midi.timeFormat) {
    if (timeFormat < 0)
        return;
    // JUCE also sums at changes of the time signature. Other sums would round differently.
    Messages changes;
    addAll(midi, isTempo, changes);
    addAll(midi, std::mem_fn(&juce::MidiMessage::isTimeSignatureMetaEvent), changes);
    std::ranges::stable_sort(changes, {}, &juce::MidiMessage::getTimeStamp);

    const auto tickLength = 1.0 / (timeFormat & 0x7fff);
    Stretch now{.fromTicks = 0, .fromSeconds = 0, .secondsPerTick = 0.5 * tickLength};
    stretches.push_back(now);
    for (auto change = changes.begin(); change != changes.end();) {
        const double ticks = (*change)->getTimeStamp();
        now.fromSeconds += (ticks - now.fromTicks) * now.secondsPerTick;
        now.fromTicks = ticks;
        for (; change != changes.end() && (*change)->getTimeStamp() == ticks; ++change)
            if (isTempo(**change))
                now.secondsPerTick = tickLength * (*change)->getTempoSecondsPerQuarterNote();
        stretches.push_back(now);
    }
}

double TempoMap::secondsAt(double ticks) const {
    if (timeFormat < 0)
        return ticks / (framesPerSecond(timeFormat) * (timeFormat & 0xff));
    const auto next = std::ranges::lower_bound(stretches.begin() + 1, stretches.end(), ticks, {},
                                               &Stretch::fromTicks);
    const auto& here = *(next - 1);
    return here.fromSeconds + (ticks - here.fromTicks) * here.secondsPerTick;
}

} // namespace idiophone
