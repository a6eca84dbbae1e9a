// Damped sinusoids, and recordings of free decays, which are sums of them.
#pragma once

#include <complex>
#include <numbers>
#include <vector>

namespace idiophone {

/// The poles −α ± 2πif of one mode.
struct DecayPole {
    double frequencyHz = 0;
    double decayPerSecond = 0; ///< α

    /// The half-power width of its resonance.
    double widthHz() const { return decayPerSecond / std::numbers::pi; }
    std::complex<double> perSecond() const {
        return {-decayPerSecond, 2 * std::numbers::pi * frequencyHz};
    }
};

/// Re(a_r e^{(−α + 2πif)t}) in recording r.
struct DampedSinusoid {
    DecayPole pole;
    std::vector<std::complex<double>> amplitudes; ///< [R]
};

/// Samples of one free decay only.
struct DecayRecording {
    std::vector<double> samples;
    double sampleRateHz = 0;

    double seconds() const { return static_cast<double>(samples.size()) / sampleRateHz; }
};

} // namespace idiophone
