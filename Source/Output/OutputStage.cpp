#include "Output/OutputStage.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace idiophone {
namespace {

/// 100 dB, more than the range of the parameter. Repeated changes of level and sound during reverb
/// could exceed it.
constexpr float maximumOwnLevel = 1e5f;
constexpr std::size_t cell = 64; ///< grid on which silence is detected

float gainOf(const ParameterValues& values) {
    const double decibels = values[ParameterId::level] + values[ParameterId::volume];
    return static_cast<float>(std::pow(10, decibels / 20));
}

/// Tests without a branch per sample.
bool allFinite(std::span<const float> samples) {
    constexpr std::uint32_t exponent = 0x7f800000u;
    bool finite = true;
    for (const float sample : samples)
        finite &= (std::bit_cast<std::uint32_t>(sample) & exponent) != exponent;
    return finite;
}

} // namespace

void OutputStage::prepare(double sampleRateHz, int maximumBlockSize) {
    samplesPerSecond = sampleRateHz;
    for (auto* ramp : {&ownLevel, &level, &open, &width})
        ramp->prepare(sampleRateHz, rampSeconds);
    ownLeft.resize(static_cast<std::size_t>(maximumBlockSize));
    ownRight.resize(static_cast<std::size_t>(maximumBlockSize));
    tilt.prepare(sampleRateHz, maximumBlockSize, rampSeconds);
    room.prepare(sampleRateHz, maximumBlockSize, rampSeconds);
    limiter.prepare(sampleRateHz, rampSeconds);
    reset();
}

void OutputStage::reset() noexcept {
    startsAtTarget = true;
    gridPosition = 0;
    forgetChanges();
    tilt.reset();
    room.reset();
    limiter.reset();
}

/// Applies the whole level behind the room.
void OutputStage::forgetChanges() noexcept {
    ownLevelAtChange = 1;
    highestLevel = std::numeric_limits<float>::infinity();
    heldSamples = 0;
}

/// Keeps the level that sounds now, and applies it behind the room from now on.
void OutputStage::moveLevelBehindRoom() noexcept {
    forgetChanges();
    level.jumpTo(ownLevel.target() * level.target());
    ownLevel.jumpTo(1);
}

float OutputStage::changeSound(const ParameterValues& values, double fadeSeconds) noexcept {
    if (startsAtTarget)
        return 1;
    const float before = ownLevel.current() * level.current();
    const float now = gainOf(values);
    ownLevelAtChange = now / level.current();
    if (ownLevelAtChange > maximumOwnLevel)
        room.reset();
    if (room.silent())
        forgetChanges();
    level.jumpTo(now / ownLevelAtChange);
    ownLevel.jumpTo(ownLevelAtChange);
    highestLevel = level.current(); // the fade may reverberate in a silent room
    heldSamples = static_cast<std::size_t>(fadeSeconds * samplesPerSecond) + 1;
    return before / now;
}

bool OutputStage::process(std::span<const float> left,
                          std::span<const float> right,
                          std::span<float* const> channels,
                          const ParameterValues& values) noexcept {
    if (left.empty() || channels.empty())
        return true;
    std::array<float*, 2> rest{};
    const auto count = std::min(channels.size(), rest.size());
    for (std::size_t start = 0, length = 0; start < left.size(); start += length) {
        length = std::min(left.size() - start, cell - gridPosition);
        if (heldSamples > 0)
            length = std::min(length, heldSamples);
        for (std::size_t channel = 0; channel < count; ++channel)
            rest[channel] = channels[channel] + start;
        if (!processPiece(left.subspan(start, length), right.subspan(start, length),
                          std::span(rest).first(count), values)) {
            for (float* channel : channels)
                std::fill_n(channel, left.size(), 0.0f);
            reset();
            return false;
        }
        gridPosition = (gridPosition + length) % cell;
    }
    return true;
}

void OutputStage::skip(std::size_t samples) noexcept {
    gridPosition = (gridPosition + samples) % cell;
    room.skip(samples);
}

bool OutputStage::processPiece(std::span<const float> left,
                               std::span<const float> right,
                               std::span<float* const> channels,
                               const ParameterValues& values) noexcept {
    if (gridPosition == 0 && room.silent() && !ownLevel.isMoving() && !level.isMoving() &&
        heldSamples == 0)
        moveLevelBehindRoom();
    if (heldSamples == 0) {
        const float wanted = gainOf(values);
        level.moveTo(std::min(wanted / ownLevelAtChange, highestLevel));
        ownLevel.moveTo(wanted / level.target());
    }
    heldSamples -= std::min(heldSamples, left.size());
    open.moveTo(values[ParameterId::bypass] != 0 ? 0.0f : 1.0f);
    width.moveTo(static_cast<float>(values[ParameterId::width] / 100));
    if (startsAtTarget)
        for (auto* ramp : {&ownLevel, &level, &open, &width})
            ramp->jumpToTarget();
    startsAtTarget = false;

    const auto tilted = tilt.process({left, right}, values[ParameterId::brightness]);
    spread(room.process(atOwnLevel(tilted), values), channels);
    if (!std::ranges::all_of(channels, [&](const float* channel) {
            return allFinite({channel, left.size()});
        }))
        return false;
    limiter.process(channels, left.size(), values[ParameterId::limiter] != 0);
    return true;
}

Room::Sound OutputStage::atOwnLevel(const Room::Sound& sound) noexcept {
    if (!ownLevel.isMoving() && ownLevel.target() == 1)
        return sound;
    const auto count = sound.left.size();
    for (std::size_t i = 0; i < count; ++i) {
        const float gain = ownLevel.next();
        ownLeft[i] = gain * sound.left[i];
        ownRight[i] = gain * sound.right[i];
    }
    return {std::span(ownLeft).first(count), std::span(ownRight).first(count)};
}

void OutputStage::spread(const Room::Sound& sound, std::span<float* const> channels) noexcept {
    const auto [left, right] = sound;
    for (std::size_t i = 0; i < left.size(); ++i) {
        const float mid = (left[i] + right[i]) / 2;
        const float side = width.next() * ((left[i] - right[i]) / 2);
        const float gain = level.next() * open.next();
        channels[0][i] = gain * (channels.size() > 1 ? mid + side : mid);
        if (channels.size() > 1)
            channels[1][i] = gain * (mid - side);
    }
}

} // namespace idiophone
