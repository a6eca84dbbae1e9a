// A recorded scrape to the figures of a surface: the exponent of its profile's power spectrum and
// the reson it is felt through (van den Doel, Kry & Pai 2001, section 5.2). Knows no files.
#pragma once

#include "Object/Result.h"

#include <span>

namespace idiophone {

struct SurfaceFit {
    double spectrumExponent = 0;      ///< β of power ∝ ω^β
    double resonFrequencyHz = 0;      ///< f and
    double resonDampingPerSecond = 0; ///< d of the pole −d ± 2πif
    double highestFrequencyHz = 0;    ///< up to which the recording was fitted
};

inline constexpr double shortestScrapeSeconds = 0.25;

/// Fits S(ω) = σ² ω^β / |A(e^{iω})|², A of order 2, to a scrape at constant speed and force. For
/// each β the recording is whitened by ω^{−β/2} and A found by the covariance method, that is by
/// least squares without a window; the β of the greatest (Whittle) likelihood is taken. Where the
/// spectrum falls off as if cut, only what lies below is fitted. At most 2¹⁹ samples, from the
/// middle, are looked at.
///
/// The error is what the recording lacks, to be put after its name: "it is silent".
Result<SurfaceFit> fitSurface(std::span<const float> samples, double sampleRateHz);

} // namespace idiophone
