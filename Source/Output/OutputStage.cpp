#include "Output/OutputStage.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace idiophone {
namespace {

/// How far the two factors of the level may come to lie apart where it is automated and sounds
/// change, over and over, while a room rings: 100 dB, more than from one end of the parameter to
/// the other.
constexpr float farthestOwnGain = 1e5f;

float gainOf(const ParameterValues& values) {
    return juce::Decibels::decibelsToGain(static_cast<float>(values[ParameterId::level]));
}

/// Without a branch for each.
bool allFinite(std::span<const float> samples) {
    constexpr std::uint32_t exponent = 0x7f800000u;
    bool finite = true;
    for (const float sample : samples)
        finite &= (std::bit_cast<std::uint32_t>(sample) & exponent) != exponent;
    return finite;
}

} // namespace

void OutputStage::prepare(double sampleRateHz, int maximumBlockSize) {
    for (auto* ramp : {&level, &open, &width})
        ramp->reset(sampleRateHz, rampSeconds);
    ownLeft.resize(static_cast<std::size_t>(maximumBlockSize));
    ownRight.resize(static_cast<std::size_t>(maximumBlockSize));
    room.prepare(sampleRateHz, maximumBlockSize, rampSeconds);
    reset();
}

void OutputStage::reset() noexcept {
    startsAtTarget = true;
    ownGain = 1;
    room.reset();
}

float OutputStage::changeSound(const ParameterValues& values) noexcept {
    if (startsAtTarget)
        return 1;
    const float before = ownGain * level.getCurrentValue();
    const float now = gainOf(values);
    ownGain = now / level.getCurrentValue();
    const bool isFar = ownGain > farthestOwnGain || ownGain < 1 / farthestOwnGain;
    if (isFar)
        room.reset();
    if (isFar || room.silent())
        ownGain = 1;
    level.setCurrentAndTargetValue(now / ownGain);
    return before / now;
}

bool OutputStage::process(std::span<const float> left,
                          std::span<const float> right,
                          std::span<float* const> channels,
                          const ParameterValues& values) noexcept {
    if (left.empty() || channels.empty())
        return true;
    level.setTargetValue(gainOf(values) / ownGain);
    open.setTargetValue(values[ParameterId::bypass] != 0 ? 0.0f : 1.0f);
    width.setTargetValue(static_cast<float>(values[ParameterId::width] / 100));
    if (startsAtTarget)
        for (auto* ramp : {&level, &open, &width})
            ramp->setCurrentAndTargetValue(ramp->getTargetValue());
    startsAtTarget = false;

    spread(room.process(atOwnLevel({left, right}), values), channels);
    if (std::ranges::all_of(channels, [&](const float* channel) {
            return allFinite({channel, left.size()});
        }))
        return true;
    for (float* channel : channels)
        std::fill_n(channel, left.size(), 0.0f);
    room.reset();
    return false;
}

Room::Sound OutputStage::atOwnLevel(const Room::Sound& sound) noexcept {
    if (ownGain == 1)
        return sound;
    const auto count = sound.left.size();
    juce::FloatVectorOperations::multiply(ownLeft.data(), sound.left.data(), ownGain,
                                          static_cast<int>(count));
    juce::FloatVectorOperations::multiply(ownRight.data(), sound.right.data(), ownGain,
                                          static_cast<int>(count));
    return {std::span(ownLeft).first(count), std::span(ownRight).first(count)};
}

void OutputStage::spread(const Room::Sound& sound, std::span<float* const> channels) noexcept {
    const auto [left, right] = sound;
    for (std::size_t i = 0; i < left.size(); ++i) {
        const float mid = (left[i] + right[i]) / 2;
        const float side = width.getNextValue() * ((left[i] - right[i]) / 2);
        const float gain = level.getNextValue() * open.getNextValue();
        channels[0][i] = gain * (channels.size() > 1 ? mid + side : mid);
        if (channels.size() > 1)
            channels[1][i] = gain * (mid - side);
    }
}

} // namespace idiophone
