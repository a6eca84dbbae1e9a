// First estimates of the poles that several free decays share in one frequency band, by a subspace
// method. JointFit refines the poles and RecordingFit chooses the bands.
#pragma once

#include "Analysis/DampedSinusoid.h"

#include <span>
#include <vector>

namespace idiophone {

struct BandPole {
    DecayPole pole;
    double energy = 0; ///< that it alone explains: squares of samples times seconds
};

/// Returns poles at most half a width from the centre.
///
/// Each recording is shifted to 0 Hz, low-passed by a filter of finite length and resampled at 1.8
/// times the width. Where the filter lies within the free decay, the result is a sum of
/// exponentials with the same poles. ESPRIT (Roy & Kailath 1989) finds these in the signal space of
/// the Hankel matrices of all recordings side by side. Poles that explain no more energy than the
/// rest of the band are left out. Steady tones are found too: their decay is near 0 or below.
///
/// The filter takes the first 5 / width seconds. The result is empty if a recording is little
/// longer.
std::vector<BandPole>
polesInBand(std::span<const DecayRecording> recordings, double centreHz, double widthHz);

} // namespace idiophone
