#include "Output/OutputStage.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace idiophone {
namespace {

float targetGain(const ParameterValues& values) {
    if (values[ParameterId::bypass] != 0)
        return 0;
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
    gain.setRampDurationSeconds(rampSeconds);
    gain.prepare({.sampleRate = sampleRateHz,
                  .maximumBlockSize = static_cast<juce::uint32>(maximumBlockSize),
                  .numChannels = 2});
    width.reset(sampleRateHz, rampSeconds);
    room.prepare(sampleRateHz, maximumBlockSize, rampSeconds);
    reset();
}

void OutputStage::reset() noexcept {
    startsAtTarget = true;
    room.reset();
}

bool OutputStage::process(std::span<const float> left,
                          std::span<const float> right,
                          std::span<float* const> channels,
                          const ParameterValues& values) noexcept {
    if (left.empty() || channels.empty())
        return true;
    gain.setGainLinear(targetGain(values));
    width.setTargetValue(static_cast<float>(values[ParameterId::width] / 100));
    if (startsAtTarget) {
        gain.reset();
        width.setCurrentAndTargetValue(width.getTargetValue());
    }
    startsAtTarget = false;

    spread(room.process({left, right}, values), channels);
    juce::dsp::AudioBlock<float> block(channels.data(), channels.size(), left.size());
    gain.process(juce::dsp::ProcessContextReplacing<float>(block));
    if (std::ranges::all_of(channels, [&](const float* channel) {
            return allFinite({channel, left.size()});
        }))
        return true;
    block.clear();
    room.reset();
    return false;
}

void OutputStage::spread(const Room::Sound& sound, std::span<float* const> channels) noexcept {
    const auto [left, right] = sound;
    for (std::size_t i = 0; i < left.size(); ++i) {
        const float mid = (left[i] + right[i]) / 2;
        const float side = width.getNextValue() * ((left[i] - right[i]) / 2);
        channels[0][i] = channels.size() > 1 ? mid + side : mid;
        if (channels.size() > 1)
            channels[1][i] = mid - side;
    }
}

} // namespace idiophone
