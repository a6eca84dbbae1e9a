// How the force of a contact ends when it is let go: half a cosine over a hundredth of a second,
// which has no corner at either end.
#pragma once

#include "Synth/SynthesisSettings.h"

#include <span>

namespace idiophone {

/// Any thread; does not allocate.
class ReleaseFade {
public:
    /// From a release to silence of the force, however far the next grid point is, at sample rates
    /// of 8 kHz and more. Below, a cell alone takes as long.
    static constexpr double seconds = 0.01;

    explicit ReleaseFade(double sampleRateHz);

    /// Multiplies a cell that begins with `left` (1 to 0) of the fade still to come.
    void apply(double left, std::span<float, cellSamples> newtons) const noexcept;

    /// What is left a cell later; 0 where it is over.
    double after(double left) const noexcept;

private:
    int samples;
};

} // namespace idiophone
