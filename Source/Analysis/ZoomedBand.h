// A frequency band of a recording as a short complex signal. BandPoles and EchoedBand use it.
#pragma once

#include "Analysis/DampedSinusoid.h"

#include <Eigen/Core>
#include <vector>

namespace idiophone {

/// Shifts the centre to 0 Hz, low-passes by a filter of finite length and resamples at 1.8 times
/// the width. The filter is level to half a width, −6 dB at 0.86 widths, −60 dB from 1.22 on.
/// Within a free decay, the result is a sum of exponentials with the poles of the decay.
class ZoomedBand {
public:
    ZoomedBand(double centreHz, double widthHz);

    double stepSeconds() const { return step; }
    /// The instant of the first new sample: half the length of the filter.
    double firstSeconds() const { return reach; }
    /// Returns how many new samples a recording of this length has; negative if it is too short.
    Eigen::Index countIn(double seconds) const;
    /// Returns the energy of a new sample of white noise of variance 1 and this sample rate.
    double noiseEnergy(double sampleRateHz) const;

    Eigen::VectorXcd of(const DecayRecording& recording, Eigen::Index count) const;

private:
    double filterAt(double seconds) const;

    double centre, width, step, reach;
    std::vector<double> table; ///< half the impulse response, because new samples lie anywhere
};

} // namespace idiophone
