// Damped sinusoids fitted to free decays by least squares, all recordings at once: exact where
// BandPoles' estimates start it near enough. It invents no modes.
#pragma once

#include "Analysis/ClusterFit.h"
#include "Analysis/DampedSinusoid.h"

#include <cstddef>
#include <span>
#include <vector>

namespace idiophone {

/// Works on the recordings' discrete Fourier transforms, in which the transform of a mode that is
/// cut off at the end of the recording is known in closed form: least squares there are least
/// squares in time (Parseval), but near modes only concern one another. Clusters of modes take
/// turns in a Levenberg-Marquardt search over their poles; the amplitudes, which are linear, are
/// solved for each pole tried (variable projection, Golub & Pereyra 1973, with Kaufman's
/// derivative).
class PoleRefinement {
public:
    /// Recordings end at most a 64th earlier here, at a length that transforms quickly.
    explicit PoleRefinement(std::span<const DecayRecording> recordings);

    /// Modes of those poles join, still without amplitudes. What is no mode that can be heard to
    /// ring stays out: below 20 Hz, above 0.49 times a sample rate, T60 over 5 minutes or under 2
    /// ms, an amplitude that falls to less than 1/e within a period.
    void add(std::span<const DecayPole> poles);

    /// Whether each cluster may also have a part that is linear in frequency, for what is not
    /// modelled yet.
    enum class Background { none, linear };
    void refine(int sweeps, Background background);

    /// Modes leave that explain no more than noise would, or are fainter than −80 dB of the
    /// strongest in every recording, or that `refine` has moved far from where they were added or
    /// last kept: those stand for what is no mode. True where any did.
    bool dropDoubtful();

    const std::vector<DampedSinusoid>& modes() const { return sinusoids; }

    /// What the modes leave of the recordings.
    std::vector<DecayRecording> residuals() const;

private:
    struct Spectrum {
        std::size_t length = 0; ///< of the transform
        double rateHz = 0;
        std::vector<double> samples;
        std::vector<std::complex<double>> residual; ///< bins 0 to length/2, less all modes

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
    /// Of each mode where it was added or last kept, and the energy it takes out of the recordings
    /// in those of one value of noise.
    std::vector<DecayPole> origins;
    std::vector<double> significances;
    double highestHz = 0;
};

} // namespace idiophone
