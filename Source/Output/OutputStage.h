// The last stage, shared by plugin and console: both channels of the sound to the channels of the
// output, at the width, level and bypass that the parameters say. Knows nothing of hosts, files or
// buses.
#pragma once

#include "Parameters/ParameterTable.h"

#include <juce_dsp/juce_dsp.h>
#include <span>

namespace idiophone {

/// `prepare` is called while nothing processes; the rest is for the audio thread and neither
/// allocates, locks nor throws. At constant parameters the samples do not depend on block sizes.
class OutputStage {
public:
    /// Level, bypass and width move linearly over this time: without steps, too fast to be heard as
    /// a fade (by ear).
    static constexpr double rampSeconds = 0.02;

    void prepare(double sampleRateHz, int maximumBlockSize);

    /// The next block starts at its level and width, without a ramp.
    void reset() noexcept;

    /// Writes `left.size()` samples, at most `maximumBlockSize`, to each channel. Of two, the first
    /// gets M + wS and the second M − wS, where M = (L + R)/2, S = (L − R)/2 and w is the width;
    /// one gets M. Left may be the first of them and right the second. Values act from the block's
    /// first sample on.
    void process(std::span<const float> left,
                 std::span<const float> right,
                 std::span<float* const> channels,
                 const ParameterValues& values) noexcept;

private:
    void spread(std::span<const float> left,
                std::span<const float> right,
                std::span<float* const> channels) noexcept;

    juce::dsp::Gain<float> gain;
    juce::SmoothedValue<float> width;
    bool startsAtTarget = true;
};

} // namespace idiophone
