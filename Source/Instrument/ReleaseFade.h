// Fades the force of a contact out when it is released: half a cosine over 10 ms, without a corner
// at either end.
#pragma once

#include "Synth/SynthesisSettings.h"

#include <span>

namespace idiophone {

/// Any thread; does not allocate.
class ReleaseFade {
public:
    /// Maximum time from a release to zero force, with the wait for the next grid point, at sample
    /// rates of 8 kHz and more. At lower rates one cell takes longer.
    static constexpr double seconds = 0.01;

    explicit ReleaseFade(double sampleRateHz);

    /// Multiplies a cell by the fade; `left`, 1 to 0, is the part of the fade remaining at the
    /// cell's start.
    void apply(double left, std::span<float, cellSamples> newtons) const noexcept;

    /// Returns the part remaining one cell later; 0 if the fade is over.
    double after(double left) const noexcept;

private:
    int samples;
};

} // namespace idiophone
