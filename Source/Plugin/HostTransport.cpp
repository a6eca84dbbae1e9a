#include "Plugin/HostTransport.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

constexpr double fastest = 2000; // beats per minute
constexpr double farthest = 1e9; // beats from the start of the song
constexpr double smallestJump =
    1.0 / 16; // beats; smaller jumps come from rounding or a tempo change

double tempoOf(const juce::AudioPlayHead::PositionInfo& position) noexcept {
    const double told = position.getBpm().orFallback(0);
    return told > 0 && told <= fastest ? told : 0;
}

std::optional<double> placeOf(const juce::AudioPlayHead::PositionInfo& position) noexcept {
    const auto told = position.getPpqPosition();
    const bool isPlace = position.getIsPlaying() && told && std::abs(*told) <= farthest;
    return isPlace && tempoOf(position) > 0 ? std::optional(*told) : std::nullopt;
}

} // namespace

double HostTransport::goneOn(double inBeatsPerMinute) const noexcept {
    return *reckoned + secondsSince * inBeatsPerMinute / 60;
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
        const auto toldBefore = std::exchange(told, placeOf(*position));
        const bool standsStill = told && told == toldBefore;
        placeNow = standsStill ? std::nullopt : told;
        beginsNow =
            placeNow &&
            !(reckoned &&
              *placeNow > std::min(goneOn(tempoBefore), goneOn(beatsPerMinute)) - smallestJump);
        reckoned = standsStill ? std::optional(goneOn(tempoBefore)) : told;
    } else {
        told = std::nullopt;
        if (reckoned)
            reckoned = goneOn(beatsPerMinute);
        if (placeNow)
            placeNow = reckoned;
    }
    secondsSince = blockSamples / sampleRateHz;
}

} // namespace idiophone
