// What recordings of free decays are made of. Knows neither samples nor objects.
#pragma once

#include <complex>
#include <numbers>
#include <vector>

namespace idiophone {

/// The poles −α ± 2πif of one mode.
struct DecayPole {
    double frequencyHz = 0;
    double decayPerSecond = 0; ///< α

    std::complex<double> perSecond() const {
        return {-decayPerSecond, 2 * std::numbers::pi * frequencyHz};
    }
};

/// Re(a_r e^{(−α + 2πif)t}) in recording r.
struct DampedSinusoid {
    DecayPole pole;
    std::vector<std::complex<double>> amplitudes; ///< [R]
};

/// A free decay: samples of it and of nothing else.
struct DecayRecording {
    std::vector<double> samples;
    double sampleRateHz = 0;

    double seconds() const { return static_cast<double>(samples.size()) / sampleRateHz; }
};

} // namespace idiophone
