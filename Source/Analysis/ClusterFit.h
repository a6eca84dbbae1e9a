// Least-squares fit of a few damped sinusoids to parts of Fourier transforms: with given poles, or
// with a search over them. PoleRefinement chooses the clusters.
#pragma once

#include "Analysis/DampedSinusoid.h"

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace idiophone {

/// The discrete Fourier transform Σ z^n w^{−n} over n < N of an exponential truncated at N, with z
/// = e^{pole/rate}, in closed form.
class CutExponential {
public:
    CutExponential(const std::complex<double>& polePerSecond, double rateHz, std::size_t length);

    /// The transform at w* = e^{−2πik/N}.
    std::complex<double> at(const std::complex<double>& conjugateBin) const {
        return (1.0 - last) / (1.0 - z * conjugateBin);
    }
    /// The transform's derivative with respect to the pole, in seconds.
    std::complex<double> slopeAt(const std::complex<double>& conjugateBin) const;

private:
    std::complex<double> z, last; ///< last = z^N
    double rate, size;
};

/// Both exponentials of a real damped sinusoid.
struct CutSinusoid {
    CutSinusoid(const DecayPole& pole, double rateHz, std::size_t length)
        : up(pole.perSecond(), rateHz, length), down(std::conj(pole.perSecond()), rateHz, length) {}

    /// The transform of Re(a z^n).
    std::complex<double> at(const std::complex<double>& amplitude,
                            const std::complex<double>& conjugateBin) const {
        return 0.5 *
               (amplitude * up.at(conjugateBin) + std::conj(amplitude) * down.at(conjugateBin));
    }

    CutExponential up, down;
};

/// e^{−2πik/N}
std::complex<double> conjugateBin(std::size_t k, std::size_t length);

/// Some bins of a recording's transform.
struct SpectrumPiece {
    std::size_t length = 0; ///< N, the length of the transform
    double rateHz = 0;
    std::size_t firstBin = 0;
    std::vector<std::complex<double>> bins;
};

struct ClusterFit {
    double cost = 0; ///< sum of squared residuals
    /// Second derivative of half the cost over (ω, ln α) of each mode, after Kaufman (1975).
    Eigen::MatrixXd curvature;
    Eigen::VectorXd slope;                                     ///< descent direction
    std::vector<std::vector<std::complex<double>>> amplitudes; ///< [modes][pieces]
    /// [modes] the energy that only this mode explains, over the noise energy of one value.
    std::vector<double> significances;
};

/// Fits modes with these poles to all pieces. Each piece has its own amplitudes and, with
/// `background`, its own term linear in frequency. Pieces with fewer values than unknowns are
/// ignored.
ClusterFit fitCluster(std::span<const DecayPole> poles,
                      std::span<const SpectrumPiece> pieces,
                      bool background);

/// Searches for the poles of the best fit by Levenberg and Marquardt's method, from `poles`, which
/// become the best found. They stay within a few widths and bins of their `origins`. The amplitudes
/// are linear and solved for each trial pole (variable projection, Golub & Pereyra 1973, with
/// Kaufman's derivative).
ClusterFit refineCluster(std::vector<DecayPole>& poles,
                         std::span<const DecayPole> origins,
                         std::span<const SpectrumPiece> pieces,
                         bool background);

} // namespace idiophone
