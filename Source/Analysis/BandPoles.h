// First estimates of the poles that several free decays share in one frequency band, by a subspace
// method. PoleRefinement refines the poles and RecordingFit chooses the bands.
#pragma once

#include "Analysis/DampedSinusoid.h"

#include <span>
#include <vector>

namespace idiophone {

/// Finds poles in bands of one width. Each recording is shifted to 0 Hz, low-passed by a filter of
/// finite length and resampled at 1.6 times the width. Where the filter lies within the free decay,
/// the result is a sum of exponentials with the same poles. ESPRIT (Roy & Kailath 1989) finds these
/// in the signal space of the Hankel matrices of all recordings side by side. Growing poles, poles
/// outside the band and poles with no more energy than the noise are left out.
class BandPoles {
public:
    /// The recordings must outlive this object.
    BandPoles(std::span<const DecayRecording> recordings, double widthHz);

    /// Returns poles at most half a width from the centre that decay no faster than the maximum.
    /// Wider bands find faster poles. The result is empty if a recording is shorter than the
    /// filter.
    std::vector<DecayPole> polesAbout(double centreHz, double fastestDecayPerSecond) const;

private:
    /// The filter for one new sample: weights of the old samples from `first` on.
    struct Taps {
        std::size_t first = 0;
        std::vector<double> weights;
    };

    std::span<const DecayRecording> recordings;
    double width, step;
    std::vector<std::vector<Taps>> taps; ///< [recordings][new samples]
};

/// Finds poles in the whole spectrum of the first milliseconds, without a filter. It serves modes
/// that decay too fast for any band.
std::vector<DecayPole> polesOfStart(std::span<const DecayRecording> recordings);

} // namespace idiophone
