#include "Analysis/BandPoles.h"

#include "Analysis/BackwardElimination.h"
#include "Analysis/ZoomedBand.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
constexpr Index longestBand = 320, minimumSamples = 24, widestHankel = 128, highestOrder = 60;
// Minimum energy of a pole in the signal space. The first figure is relative to the noise, which
// spreads in a Hankel matrix. The second is relative to the maximum energy, against rounding
// errors.
constexpr double aboveNoise = 4, aboveRounding = 1e-13;
// The minimum energy that a pole alone explains, over the noise energy of one value and over the
// energy of the band.
constexpr double energyOverNoise = 10, energyOverNoiseEach = 4, energyInBand = 3e-5;
// |z| of a new sample: a pole that loses more is gone before the filter has passed, and one that
// grows by more is no steady tone.
constexpr double fastest = 0.2, growth = 1.02;

/// Returns z of the exponentials z^m that the signals share. The number may be too high, but
/// is seldom too low.
VectorXcd commonExponentials(const std::vector<VectorXcd>& signals) {
    const Index length = signals.front().size();
    const Index rows = std::min(length * 2 / 5, widestHankel);
    MatrixXcd covariance = MatrixXcd::Zero(rows, rows);
    for (const auto& signal : signals) {
        MatrixXcd hankel(rows, length - rows + 1);
        for (Index column = 0; column < hankel.cols(); ++column)
            hankel.col(column) = signal.segment(column, rows);
        covariance.selfadjointView<Eigen::Lower>().rankUpdate(hankel);
    }
    const Eigen::SelfAdjointEigenSolver<MatrixXcd> solver(covariance);
    const VectorXd& energies = solver.eigenvalues(); // ascending
    const double noise = energies.head(std::max<Index>(1, rows / 4)).mean();
    const double faintest = std::max(aboveNoise * noise, aboveRounding * energies(rows - 1));
    Index order = 0;
    while (order < std::min(rows / 2, highestOrder) && energies(rows - 1 - order) > faintest)
        ++order;
    if (order == 0)
        return {};
    const MatrixXcd space = solver.eigenvectors().rightCols(order);
    const MatrixXcd upper = space.topRows(rows - 1), lower = space.bottomRows(rows - 1);
    const MatrixXcd rotation = (upper.adjoint() * upper).ldlt().solve(upper.adjoint() * lower);
    return Eigen::ComplexEigenSolver<MatrixXcd>(rotation, false).eigenvalues();
}

struct Exponential {
    Complex z;
    double energy = 0; ///< that it alone explains in all signals
};

/// Fits all amplitudes together and returns the exponentials that are needed.
std::vector<Exponential> needed(const std::vector<VectorXcd>& signals,
                                const std::vector<Complex>& exponentials) {
    const Index length = signals.front().size();
    const auto count = static_cast<Index>(exponentials.size());
    MatrixXcd powers(length, count);
    for (Index i = 0; i < count; ++i) {
        powers(0, i) = 1;
        for (Index m = 1; m < length; ++m)
            powers(m, i) = powers(m - 1, i) * exponentials[i];
    }
    const auto each = static_cast<double>(signals.size());
    const MatrixXcd gram = powers.adjoint() * powers;
    const Eigen::ColPivHouseholderQR<MatrixXcd> solver(powers);
    BackwardElimination<Complex, 1> elimination;
    Eigen::MatrixXd floors(count, signals.size());
    for (std::size_t s = 0; s < signals.size(); ++s) {
        elimination.add(gram, powers.adjoint() * signals[s]);
        const double rest = (signals[s] - powers * solver.solve(signals[s])).squaredNorm();
        const double noise = rest / static_cast<double>(std::max<Index>(1, length - count));
        floors.col(static_cast<Index>(s))
            .setConstant(std::max({(energyOverNoise + energyOverNoiseEach * each) * noise,
                                   energyInBand * signals[s].squaredNorm(), 1e-300}));
    }
    elimination.run(floors, count);
    std::vector<Exponential> result;
    for (Index i = 0; i < count; ++i) {
        if (!elimination.keeps(i))
            continue;
        auto& kept = result.emplace_back(Exponential{.z = exponentials[i]});
        for (std::size_t s = 0; s < signals.size(); ++s)
            kept.energy += elimination.ownEnergy(i, s);
    }
    return result;
}

} // namespace

std::vector<BandPole>
polesInBand(std::span<const DecayRecording> recordings, double centreHz, double widthHz) {
    const ZoomedBand band(centreHz, widthHz);
    double shortest = recordings.front().seconds();
    for (const auto& recording : recordings)
        shortest = std::min(shortest, recording.seconds());
    const Index count = std::min(band.countIn(shortest), longestBand);
    if (count < minimumSamples)
        return {};
    std::vector<VectorXcd> signals;
    for (const auto& recording : recordings)
        signals.push_back(band.of(recording, count));
    std::vector<Complex> exponentials;
    for (const Complex& z : commonExponentials(signals))
        if (std::abs(z) > fastest && std::abs(z) < growth)
            exponentials.push_back(z);
    std::vector<BandPole> poles;
    if (exponentials.empty())
        return poles;
    for (const auto& [z, energy] : needed(signals, exponentials)) {
        const Complex pole = std::log(z) / band.stepSeconds();
        const double offsetHz = pole.imag() / (2 * pi);
        if (std::abs(offsetHz) <= 0.505 * widthHz)
            poles.push_back(
                {.pole = {.frequencyHz = centreHz + offsetHz, .decayPerSecond = -pole.real()},
                 .energy = energy * band.stepSeconds()});
    }
    return poles;
}

} // namespace idiophone
