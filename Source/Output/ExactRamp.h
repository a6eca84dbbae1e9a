// Ramps that end at exactly the value that they were given.
#pragma once

#include <juce_dsp/juce_dsp.h>

namespace idiophone {

/// Starts a ramp to a value, as `setTargetValue` does. JUCE ignores a target that differs from the
/// present one only by rounding. The sound would then depend on earlier values. Audio thread.
template <class Smoothing>
void rampTo(juce::SmoothedValue<float, Smoothing>& ramp, float value) noexcept {
    ramp.setTargetValue(value);
    if (ramp.getTargetValue() != value && ramp.isSmoothing()) {
        ramp.setCurrentAndTargetValue(ramp.getCurrentValue());
        ramp.setTargetValue(value);
    }
    if (ramp.getTargetValue() != value)
        ramp.setCurrentAndTargetValue(value);
}

} // namespace idiophone
