#include "Plugin/HostTransport.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

constexpr double maximumTempo = 2000; // beats per minute
constexpr double maximumBeats = 1e9;  // beats from the start of the song
constexpr double smallestJump =
    1.0 / 16; // beats; smaller jumps come from rounding or a tempo change

double tempoOf(const juce::AudioPlayHead::PositionInfo& position) noexcept {
    const double reported = position.getBpm().orFallback(0);
    return reported > 0 && reported <= maximumTempo ? reported : 0;
}

std::optional<double> placeOf(const juce::AudioPlayHead::PositionInfo& position) noexcept {
    const auto reported = position.getPpqPosition();
    const bool isPlace = position.getIsPlaying() && reported && std::abs(*reported) <= maximumBeats;
    return isPlace && tempoOf(position) > 0 ? std::optional(*reported) : std::nullopt;
}

} // namespace

double HostTransport::extrapolated(double inBeatsPerMinute) const noexcept {
    return *lastPlace + secondsSince * inBeatsPerMinute / 60;
}

void HostTransport::follow(const juce::AudioPlayHead* host,
                           int blockSamples,
                           double sampleRateHz) noexcept {
    beginsNow = false;
    if (blockSamples <= 0)
        return;
    if (host == nullptr)
        return forget();
    if (const auto position = host->getPosition()) {
        const double tempoBefore = std::exchange(beatsPerMinute, tempoOf(*position));
        const auto reportedBefore = std::exchange(reported, placeOf(*position));
        const bool standsStill = reported && reported == reportedBefore;
        placeNow = standsStill ? std::nullopt : reported;
        beginsNow = placeNow && !(lastPlace && *placeNow > std::min(extrapolated(tempoBefore),
                                                                    extrapolated(beatsPerMinute)) -
                                                               smallestJump);
        lastPlace = standsStill ? std::optional(extrapolated(tempoBefore)) : reported;
    } else {
        reported = std::nullopt;
        if (lastPlace)
            lastPlace = extrapolated(beatsPerMinute);
        if (placeNow)
            placeNow = lastPlace;
    }
    secondsSince = blockSamples / sampleRateHz;
}

} // namespace idiophone
