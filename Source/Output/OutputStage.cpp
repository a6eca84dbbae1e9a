#include "Output/OutputStage.h"

#include <algorithm>

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
    reset();
}

void OutputStage::reset() noexcept {
    startsAtTarget = true;
}

void OutputStage::process(std::span<const float> mono,
                          std::span<float* const> channels,
                          const ParameterValues& values) noexcept {
    if (mono.empty() || channels.empty())
        return;
    gain.setGainLinear(targetGain(values));
    if (startsAtTarget)
        gain.reset();
    startsAtTarget = false;

    for (float* channel : channels)
        if (channel != mono.data())
            std::copy(mono.begin(), mono.end(), channel);
    juce::dsp::AudioBlock<float> block(channels.data(), channels.size(), mono.size());
    gain.process(juce::dsp::ProcessContextReplacing<float>(block));
}

} // namespace idiophone
