#include "Output/Room.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

// juce::Reverb (Freeverb): eight combs in parallel for each channel, whose delays are 25 to 37 ms,
// and whose feedback is 0.7 + 0.28 of the room size. Of the tail the longer ones have the more.
constexpr double meanCombSeconds = 0.0325;
constexpr double shortestCombSeconds = 0.0253, longestCombSeconds = 0.0372;
static_assert(Room::earliestSeconds < shortestCombSeconds);
constexpr double feedbackOffset = 0.7, feedbackScale = 0.28;
// High frequencies die sooner than low ones, as in a furnished room: each comb's low-pass keeps a
// fifth of its last sample at 48 kHz (JUCE's middle setting), and as much of that time at any rate.
constexpr double dampingAt48kHz = 0.2, dampingScale = 0.4;
// What makes noise in a room of 1 s at 100 % as strong as the noise itself (measured).
constexpr float wetLevel = 0.77f;
constexpr int gridSamples = 64;

float roomSizeFor(double decaySeconds) {
    const double feedback = std::pow(10, -3 * meanCombSeconds / decaySeconds);
    return static_cast<float>((feedback - feedbackOffset) / feedbackScale);
}

float dampingFor(double rateHz) {
    return static_cast<float>(std::pow(dampingAt48kHz, 48000 / rateHz) / dampingScale);
}

float highest(std::span<const float> samples) {
    const auto range = juce::FloatVectorOperations::findMinAndMax(samples.data(),
                                                                  static_cast<int>(samples.size()));
    return std::max(-range.getStart(), range.getEnd());
}

} // namespace

void Room::prepare(double sampleRateHz, int maximumBlockSize, double rampSeconds) {
    // The combs have whole samples, and count them in 32 bits.
    rateHz = std::clamp(sampleRateHz, 1000.0, 1e6);
    amount.reset(sampleRateHz, rampSeconds);
    fadeSamples = static_cast<int>(std::min(rampSeconds, earliestSeconds) * rateHz);
    for (auto* samples : {&wetLeft, &wetRight, &fadingLeft, &fadingRight})
        samples->resize(static_cast<std::size_t>(maximumBlockSize));
    decaySeconds = 0; // is set anew
    for (auto& reverb : reverbs)
        reverb.setSampleRate(rateHz);
    reset();
}

void Room::reset() noexcept {
    startsAtTarget = true;
    unanswered = 0;
    rest();
}

/// Two reverberators take turns: rendering what fades ahead would be 20 ms of work in one callback.
void Room::hush(std::size_t samples) noexcept {
    unanswered = samples;
    // While one fades the other has not been heard yet: the ramp is shorter than its combs.
    if (!isSilent && fadeLeft == 0) {
        fadeLeft = fadeSamples;
        playing = 1 - playing;
    }
    isSilent = true;
}

bool Room::isShut() const noexcept {
    return !amount.isSmoothing() && amount.getTargetValue() == 0;
}

void Room::rest() noexcept {
    isSilent = true;
    fadeLeft = 0;
    gridPosition = quietSamples = 0;
}

/// Silent, and gliding nowhere. Allocates only where the rate is new, that is, in `prepare`.
void Room::settle() noexcept {
    reverbs[playing].setSampleRate(rateHz);
}

void Room::follow(const ParameterValues& values) noexcept {
    amount.setTargetValue(static_cast<float>(values[ParameterId::room] / 100));
    if (startsAtTarget)
        amount.setCurrentAndTargetValue(amount.getTargetValue());
    startsAtTarget = false;
    if (values[ParameterId::roomDecay] == decaySeconds)
        return;
    decaySeconds = values[ParameterId::roomDecay];
    for (auto& reverb : reverbs)
        reverb.setParameters({.roomSize = roomSizeFor(decaySeconds),
                              .damping = dampingFor(rateHz),
                              .wetLevel = wetLevel,
                              .dryLevel = 0,
                              .width = 1,
                              .freezeMode = 0});
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
        const float gain = amount.getNextValue();
        wetLeft[i] = sound.left[i] + gain * wetLeft[i];
        wetRight[i] = sound.right[i] + gain * wetRight[i];
    }
    if (isShut())
        rest();
    return {std::span(wetLeft).first(count), std::span(wetRight).first(count)};
}

/// Within a cell of the grid: what is put in becomes what the room answers.
void Room::ring(std::span<float> left, std::span<float> right) noexcept {
    const bool hasInput = highest(left) > 0 || highest(right) > 0;
    if (hasInput && isSilent) {
        settle();
        isSilent = false;
        quietSamples = 0;
    }
    const auto count = static_cast<int>(left.size());
    if (!isSilent) {
        reverbs[playing].processStereo(left.data(), right.data(), count);
        if (hasInput || std::max(highest(left), highest(right)) > silence)
            quietSamples = -gridSamples; // this cell does not count
    }
    gridPosition += count;
    if (gridPosition == gridSamples) {
        gridPosition = 0;
        if (!isSilent)
            quietSamples += gridSamples;
        if (quietSamples > longestCombSeconds * rateHz)
            isSilent = true;
    }
}

void Room::addFading(std::span<float> left, std::span<float> right) noexcept {
    const auto count = std::min(left.size(), static_cast<std::size_t>(fadeLeft));
    if (count == 0)
        return;
    std::ranges::fill(std::span(fadingLeft).first(count), 0.0f);
    std::ranges::fill(std::span(fadingRight).first(count), 0.0f);
    reverbs[1 - playing].processStereo(fadingLeft.data(), fadingRight.data(),
                                       static_cast<int>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const float gain = static_cast<float>(--fadeLeft) / static_cast<float>(fadeSamples);
        left[i] += gain * fadingLeft[i];
        right[i] += gain * fadingRight[i];
    }
}

} // namespace idiophone
