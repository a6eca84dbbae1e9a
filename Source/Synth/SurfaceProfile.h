// SPDX-License-Identifier: Apache-2.0
// A surface prepared for one sample rate: a periodic noise table of its profile, and gains that
// bring every speed to unit rms. Immutable; contacts may share it.
#pragma once

#include "Synth/Reson.h"
#include "Synth/Surface.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace idiophone {

/// Construction computes 1 MB in about 50 ms: not for the audio thread.
class SurfaceProfile {
public:
    /// One period, in samples at the reference speed: 1.4 s at 48 kHz.
    static constexpr std::size_t periodSamples = std::size_t{1} << 16;
    /// Table entries per sample. The table holds nothing above an eighth of its own rate, so that
    /// linear interpolation is clean at every speed.
    static constexpr std::size_t oversampling = 4;
    /// The longest wavelength as a fraction of the period. Longer wavelengths, below about 20 Hz at
    /// the reference speed, would only be heard as unsteady loudness.
    static constexpr std::size_t lowestHarmonic = 32;

    /// The same surface and seed give the same table everywhere, except for the last bits of the
    /// platform's sine and power. `surface` is valid (Surface.h).
    SurfaceProfile(Surface surface, double sampleRateHz, std::uint64_t seed);

    const Surface& surface() const noexcept { return playedSurface; }
    double sampleRateHz() const noexcept { return rateHz; }

    /// Returns the profile at 0 ≤ `position` < `periodSamples`, linearly interpolated. Over a
    /// period its mean is 0, its rms 1 and its power spectrum ∝ ω^β from `lowestHarmonic` up to
    /// half the sample rate.
    double at(double position) const noexcept {
        const double entry = position * oversampling;
        const auto index = static_cast<std::size_t>(entry);
        const double before = table[index], after = table[index + 1];
        return before + (entry - static_cast<double>(index)) * (after - before);
    }

    /// Returns the reson at this fraction of the reference speed, at most 1.
    ResonPole resonPole(double speedRatio) const noexcept;

    /// Returns 1 / rms of the profile after the reson (of unit gain at zero) at this fraction of
    /// the reference speed.
    double gain(double speedRatio) const noexcept;

private:
    static constexpr std::size_t gainCount = 17; ///< at speed ratios 0, 1/16 ... 1

    double scrapeRms(double speedRatio) const;

    Surface playedSurface;
    double rateHz;
    std::vector<float> table; ///< a period, then its first entry again
    std::array<double, gainCount> gains{};
};

} // namespace idiophone
