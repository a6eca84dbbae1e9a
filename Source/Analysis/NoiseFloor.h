// The level of steady noise over frequency.
#pragma once

#include <span>
#include <vector>

namespace idiophone {

/// Holds the spectrum of a piece of noise. A median over neighbouring frequencies leaves out tones.
class NoiseFloor {
public:
    /// Uses the last 65536 samples. With fewer than 256, the noise is unknown and 0 is returned.
    NoiseFloor(std::span<const double> noise, double sampleRateHz);

    /// Returns the energy of one value of noise of a narrow band: for white noise its variance.
    double energyAt(double hz) const;

    /// Returns the mean energy of a sample of the whole noise, with its tones.
    double meanEnergy() const { return mean; }

private:
    double binHz = 1, mean = 0;
    std::vector<double> energies; ///< [bins]
};

} // namespace idiophone
