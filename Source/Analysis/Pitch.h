// The damped frequency of a mode, and frequency ratios in cents.
#pragma once

#include "Object/Material.h"

#include <cmath>

namespace idiophone {

/// Returns the frequency in Hz of a mode damped by its material's law.
inline double dampedFrequencyHz(double eigenvalue, const Material& material) {
    return dampedFrequencyHz(eigenvalue, material.damping.perSecond(eigenvalue) / 2);
}

/// Returns a frequency ratio in cents, 1/100 of an equal-tempered semitone.
inline double cents(double frequencyHz, double referenceHz) {
    return 1200 * std::log2(frequencyHz / referenceHz);
}

} // namespace idiophone
