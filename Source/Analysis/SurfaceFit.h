// Fits a surface to a recorded scrape: the exponent of its profile's power spectrum, and its reson
// (van den Doel, Kry & Pai 2001, section 5.2). Reads no files.
#pragma once

#include "Object/Result.h"

#include <span>

namespace idiophone {

struct SurfaceFit {
    double spectrumExponent = 0;      ///< β of power ∝ ω^β
    double resonFrequencyHz = 0;      ///< f
    double resonDampingPerSecond = 0; ///< d, for the pole −d ± 2πif
    double highestFrequencyHz = 0;    ///< upper end of the fit
};

inline constexpr double shortestScrapeSeconds = 0.25;

/// Fits S(ω) = σ² ω^β / |A(e^{iω})|², A of order 2, to a scrape at constant speed and force. For
/// each β, the recording is whitened by ω^{−β/2}. The covariance method (least squares without a
/// window) finds A. The β of the greatest (Whittle) likelihood wins. If the spectrum is cut off,
/// only the part below is fitted. At most 2¹⁹ samples from the middle are used.
///
/// An error continues a sentence that starts with the recording's name: "it is silent".
Result<SurfaceFit> fitSurface(std::span<const float> samples, double sampleRateHz);

} // namespace idiophone
