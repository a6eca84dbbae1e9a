#include "Output/OutputStage.h"

namespace idiophone {
namespace {

float targetGain(const ParameterValues& values) {
    if (values[ParameterId::bypass] != 0)
        return 0;
    return juce::Decibels::decibelsToGain(static_cast<float>(values[ParameterId::level]));
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

void OutputStage::process(std::span<const float> left,
                          std::span<const float> right,
                          std::span<float* const> channels,
                          const ParameterValues& values) noexcept {
    if (left.empty() || channels.empty())
        return;
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
