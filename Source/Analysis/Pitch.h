// Where a mode sounds, and how far that is from where it should.
#pragma once

#include "Object/Material.h"

#include <cmath>

namespace idiophone {

/// The frequency in Hz of a mode that is damped by its material's law.
inline double dampedFrequencyHz(double eigenvalue, const Material& material) {
    return dampedFrequencyHz(eigenvalue, material.damping.perSecond(eigenvalue) / 2);
}

/// Frequency ratio as 1/100 of an equal-tempered semitone.
inline double cents(double frequencyHz, double referenceHz) {
    return 1200 * std::log2(frequencyHz / referenceHz);
}

} // namespace idiophone
