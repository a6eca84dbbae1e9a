// Fits damped sinusoids to all free decays at once by least squares. It is exact if the estimates
// of BandPoles are near enough. It adds no modes.
#pragma once

#include "Analysis/ClusterFit.h"
#include "Analysis/DampedSinusoid.h"

#include <cstddef>
#include <span>
#include <vector>

namespace idiophone {

/// Works on the discrete Fourier transforms of the recordings. There, the transform of a mode
/// truncated at the end of the recording has a closed form. Least squares there equal least squares
/// in time (Parseval), and only near modes interact.
///
/// Clusters of modes take turns in a search over their poles (`refineCluster`).
class PoleRefinement {
public:
    /// Truncates recordings by at most a 64th to a length with a fast transform.
    explicit PoleRefinement(std::span<const DecayRecording> recordings);

    /// Adds modes with these poles and no amplitudes. Ignores poles that cannot be audible modes:
    /// below 20 Hz, above 0.49 times a sample rate, T60 over 5 minutes or under 2 ms, or an
    /// amplitude that falls below 1/e within a period.
    void add(std::span<const DecayPole> poles);

    /// `linear` gives each cluster a term linear in frequency, for parts that are not modelled yet.
    enum class Background { none, linear };
    void refine(int sweeps, Background background);

    /// Removes doubtful modes and returns true if there were any. A mode is doubtful if it explains
    /// no more than noise, or if it is below −80 dB of the strongest in every recording. It is also
    /// doubtful if `refine` moved it far from where it was added or last kept.
    bool dropDoubtful();

    /// Returns the modes, ascending in frequency.
    std::vector<DampedSinusoid> modes() const;

    /// Returns the recordings minus all modes.
    std::vector<DecayRecording> residuals() const;

private:
    struct Spectrum {
        std::size_t length = 0; ///< length of the transform
        double rateHz = 0;
        std::vector<double> samples;
        std::vector<std::complex<double>> residual; ///< bins 0 to length/2, minus all modes

        double binHz() const { return rateHz / static_cast<double>(length); }
    };
    struct Mode {
        DampedSinusoid sinusoid;
        DecayPole origin;        ///< the pole where the mode was added or last kept
        double significance = 0; ///< energy that it explains, over the noise energy of one value
    };
    struct Cluster;

    bool isDoubtful(const Mode& mode, const std::vector<double>& strongest) const;
    std::vector<Cluster> clusters() const;
    void refine(const Cluster& cluster, Background background);
    double loudness(const Cluster& cluster) const;
    void changeResidual(const Cluster& cluster, double sign);
    void sortModes();
    void recompute();
    std::vector<double> residualOf(const Spectrum& spectrum, std::size_t recording) const;

    std::vector<Spectrum> spectra;
    std::vector<Mode> found; ///< ascending in frequency between calls
    double highestHz = 0;
};

} // namespace idiophone
