// SPDX-License-Identifier: Apache-2.0
// The sound of a surface when a body is dragged or rolled over it: plain data, after van den Doel,
// Kry & Pai 2001, section 5. File format: docs/surfaces.md.
#pragma once

#include "Object/Result.h"

#include <cstddef>
#include <string>

namespace idiophone {

/// A rough profile, whose power spectrum follows ω^β, heard through a resonance (the paper's
/// reson). The resonance's frequency and damping are proportional to the contact's speed.
struct Surface {
    static constexpr std::size_t longestNameBytes = 1000;

    std::string name = {}; ///< at most `longestNameBytes`, so that files stay readable
    /// β, −4 to 1. A profile of fractal dimension D has β = 2 (D − 2). Machined surfaces have −1.66
    /// to −1.22.
    double spectrumExponent = -1.4;
    double resonFrequencyHz = 500;       ///< at the reference speed, 10 to 20000
    double resonDampingPerSecond = 1000; ///< d of e^{−dt} at the reference speed, 1 to 100000
    /// v_max, 0.001 to 100: the speed at which the profile is read sample by sample. Faster
    /// contacts get louder but not higher.
    double referenceSpeedMetresPerSecond = 1;
    /// 0 to v_max: slower contacts are silent.
    double slowestSpeedMetresPerSecond = 0.1;
    /// 0 to 100: the rms force in newtons at the reference speed under a normal force of 1 N.
    double roughness = 0.5;

    double fractalDimension() const { return spectrumExponent / 2 + 2; }

    bool operator==(const Surface&) const = default;
};

/// Returns the surface with each value clamped to its range.
Surface heldToRanges(Surface surface);

/// Returns the surface unchanged, or an error if a value is out of range or the name is too long.
Result<Surface> validated(Surface surface);

} // namespace idiophone
