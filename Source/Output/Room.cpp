#include "Output/Room.h"

#include "Output/HighestMagnitude.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

constexpr int gridSamples = 64;

} // namespace

void Room::prepare(double sampleRateHz, int maximumBlockSize, double rampSeconds) {
    // Delays are whole samples, so the rate has bounds.
    rateHz = std::clamp(sampleRateHz, 1000.0, 1e6);
    amount.prepare(sampleRateHz, rampSeconds);
    fadeSamples = static_cast<int>(std::min(rampSeconds, earliestSeconds) * rateHz);
    for (auto* samples : {&wetLeft, &wetRight, &fadingLeft, &fadingRight})
        samples->resize(static_cast<std::size_t>(maximumBlockSize));
    for (auto& network : networks)
        network.prepare(rateHz, rampSeconds);
    reset();
}

void Room::reset() noexcept {
    startsAtTarget = true;
    unanswered = 0;
    rest();
}

/// Alternates between two networks, because rendering the fade in advance would take 20 ms in one
/// callback.
void Room::hush(std::size_t samples) noexcept {
    unanswered = samples;
    // While one network fades, the other has no output yet: the ramp is no longer than its shortest
    // line.
    if (!isSilent && fadeLeft == 0) {
        fadeLeft = fadeSamples;
        playing = 1 - playing;
    }
    isSilent = true;
}

void Room::skip(std::size_t samples) noexcept {
    unanswered -= std::min(unanswered, samples);
    gridPosition =
        static_cast<int>((static_cast<std::size_t>(gridPosition) + samples) % gridSamples);
}

bool Room::isShut() const noexcept {
    return !amount.isMoving() && amount.target() == 0;
}

void Room::rest() noexcept {
    isSilent = true;
    fadeLeft = 0;
    gridPosition = quietSamples = 0;
}

void Room::follow(const ParameterValues& values) noexcept {
    amount.moveTo(static_cast<float>(values[ParameterId::room] / 100));
    if (startsAtTarget)
        amount.jumpToTarget();
    startsAtTarget = false;
    for (auto& network : networks)
        network.setDecay(values[ParameterId::roomDecay]);
}

Room::Sound Room::process(const Sound& sound, const ParameterValues& values) noexcept {
    const auto count = sound.left.size();
    const auto dry = std::min(unanswered, count);
    unanswered -= dry;
    follow(values);
    if (isShut()) {
        rest();
        return sound;
    }
    std::ranges::copy(sound.left, wetLeft.begin());
    std::ranges::copy(sound.right, wetRight.begin());
    std::ranges::fill(std::span(wetLeft).first(dry), 0.0f);
    std::ranges::fill(std::span(wetRight).first(dry), 0.0f);
    for (std::size_t done = 0; done < count;) {
        const auto piece =
            std::min(count - done, static_cast<std::size_t>(gridSamples - gridPosition));
        ring(std::span(wetLeft).subspan(done, piece), std::span(wetRight).subspan(done, piece));
        done += piece;
    }
    addFading(std::span(wetLeft).first(count), std::span(wetRight).first(count));
    for (std::size_t i = 0; i < count; ++i) {
        const float gain = amount.next();
        wetLeft[i] = sound.left[i] + gain * wetLeft[i];
        wetRight[i] = sound.right[i] + gain * wetRight[i];
    }
    if (isShut())
        rest();
    return {std::span(wetLeft).first(count), std::span(wetRight).first(count)};
}

/// Replaces a piece within one grid cell by the room's response to it.
void Room::ring(std::span<float> left, std::span<float> right) noexcept {
    const bool hasInput = highestMagnitude(left) > 0 || highestMagnitude(right) > 0;
    if (hasInput && isSilent) {
        networks[playing].clear();
        isSilent = false;
        quietSamples = 0;
    }
    if (!isSilent) {
        networks[playing].process(left, right);
        if (hasInput || std::max(highestMagnitude(left), highestMagnitude(right)) > silence)
            quietSamples = -gridSamples; // the count of quiet samples starts after this cell
    }
    gridPosition += static_cast<int>(left.size());
    if (gridPosition == gridSamples) {
        gridPosition = 0;
        if (!isSilent)
            quietSamples += gridSamples;
        if (quietSamples > DelayNetwork::longestSeconds * rateHz)
            isSilent = true;
    }
}

void Room::addFading(std::span<float> left, std::span<float> right) noexcept {
    const auto count = std::min(left.size(), static_cast<std::size_t>(fadeLeft));
    if (count == 0)
        return;
    std::ranges::fill(std::span(fadingLeft).first(count), 0.0f);
    std::ranges::fill(std::span(fadingRight).first(count), 0.0f);
    networks[1 - playing].process(std::span(fadingLeft).first(count),
                                  std::span(fadingRight).first(count));
    for (std::size_t i = 0; i < count; ++i) {
        const float gain = static_cast<float>(--fadeLeft) / static_cast<float>(fadeSamples);
        left[i] += gain * fadingLeft[i];
        right[i] += gain * fadingRight[i];
    }
}

} // namespace idiophone
