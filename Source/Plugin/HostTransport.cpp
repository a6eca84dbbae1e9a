#include "Plugin/HostTransport.h"

#include <cmath>

namespace idiophone {
namespace {

constexpr double fastest = 2000;          // beats a minute
constexpr double farthest = 1e9;          // beats from the start of the song
constexpr double smallestJump = 1.0 / 16; // of a beat; less is how hosts round, or a tempo moves

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

void HostTransport::follow(const juce::AudioPlayHead* host,
                           int blockSamples,
                           double sampleRateHz) noexcept {
    const auto expected = placeAfter;
    if (host == nullptr)
        forget();
    else if (const auto position = host->getPosition()) {
        beatsPerMinute = tempoOf(*position);
        placeNow = placeOf(*position);
    } else
        placeNow = expected;
    beginsNow = placeNow && !(expected && std::abs(*placeNow - *expected) < smallestJump);
    placeAfter = placeNow;
    if (placeAfter)
        *placeAfter += blockSamples * beatsPerMinute / 60 / sampleRateHz;
}

} // namespace idiophone
