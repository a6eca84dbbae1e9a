// The last stage, shared by plugin and console: the mono stream on every channel, at the level and
// bypass that the parameters say. Knows nothing of hosts, files or buses.
#pragma once

#include "Parameters/ParameterTable.h"

#include <juce_dsp/juce_dsp.h>
#include <span>

namespace idiophone {

/// `prepare` is called while nothing processes; the rest is for the audio thread and neither
/// allocates, locks nor throws. At constant parameters the samples do not depend on block sizes.
class OutputStage {
public:
    /// Level and bypass move linearly in gain over this time: without steps, too fast to be heard
    /// as a fade (by ear).
    static constexpr double rampSeconds = 0.02;

    void prepare(double sampleRateHz, int maximumBlockSize);

    /// The next block starts at its level, without a ramp.
    void reset() noexcept;

    /// Writes `mono.size()` samples, at most `maximumBlockSize`, to each channel; `mono` may be one
    /// of them. Values act from the block's first sample on.
    void process(std::span<const float> mono,
                 std::span<float* const> channels,
                 const ParameterValues& values) noexcept;

private:
    juce::dsp::Gain<float> gain;
    bool startsAtTarget = true;
};

} // namespace idiophone
