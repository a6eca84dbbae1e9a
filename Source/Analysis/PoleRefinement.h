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
/// Clusters of modes take turns in a Levenberg-Marquardt search over their poles. The amplitudes
/// are linear and solved for each trial pole (variable projection, Golub & Pereyra 1973, with
/// Kaufman's derivative).
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

    const std::vector<DampedSinusoid>& modes() const { return sinusoids; }

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
    struct Cluster;

    std::vector<Cluster> clusters() const;
    void refine(const Cluster& cluster, Background background);
    ClusterFit settle(const Cluster& cluster,
                      std::vector<DecayPole>& poles,
                      const std::vector<SpectrumPiece>& pieces,
                      bool background) const;
    double loudness(const Cluster& cluster) const;
    DecayPole moved(std::size_t mode, const DecayPole& pole, double upHz, double faster) const;
    void changeResidual(const Cluster& cluster, double sign);
    void sortModes();
    void recompute();
    std::vector<double> residualOf(const Spectrum& spectrum, std::size_t recording) const;

    std::vector<Spectrum> spectra;
    std::vector<DampedSinusoid> sinusoids; ///< ascending in frequency between calls
    /// For each mode: the pole where it was added or last kept, and the energy that it explains,
    /// over the noise energy of one value.
    std::vector<DecayPole> origins;
    std::vector<double> significances;
    double highestHz = 0;
};

} // namespace idiophone
