// The poles that several free decays share in one band of frequencies, by a subspace method. First
// estimates: PoleRefinement makes them exact, RecordingFit chooses the bands.
#pragma once

#include "Analysis/DampedSinusoid.h"

#include <span>
#include <vector>

namespace idiophone {

/// Bands of one width. Each recording is shifted to 0 Hz, cut to the band by a filter of finite
/// length, and sampled anew at 1.6 times the width. Where the filter lies within the free decay,
/// the outcome is a sum of exponentials with the same poles; ESPRIT (Roy & Kailath 1989) finds them
/// from the signal space of the Hankel matrices of all recordings side by side. Poles that grow,
/// that lie beyond the band's edges, or whose energy the noise could have, are left out.
class BandPoles {
public:
    /// The recordings outlive it.
    BandPoles(std::span<const DecayRecording> recordings, double widthHz);

    /// At most half a width from the centre, and no faster than that: faster ones are left to wider
    /// bands. None where the recordings are shorter than the filter.
    std::vector<DecayPole> polesAbout(double centreHz, double fastestDecayPerSecond) const;

private:
    /// The filter about one new sample: weights of old samples from `first` on.
    struct Taps {
        std::size_t first = 0;
        std::vector<double> weights;
    };

    std::span<const DecayRecording> recordings;
    double width, step;
    std::vector<std::vector<Taps>> taps; ///< [recordings][new samples]
};

/// The same of the whole spectrum, without a filter, from the first milliseconds: for what dies
/// away too fast for any band.
std::vector<DecayPole> polesOfStart(std::span<const DecayRecording> recordings);

} // namespace idiophone
