#include "Analysis/DampingFit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace idiophone {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Relative deviations of decays: smallest that is told from an exact law, and where a decay begins
// to count less.
constexpr double leastDeviation = 0.01, usualDeviation = 0.1;

/// The law as a linear problem: `terms` x = 1 for each decay.
struct Fit {
    VectorXd law;                                          ///< [terms]
    double criterion = std::numeric_limits<double>::max(); ///< Schwarz's; low is good
};

/// Fits the columns `used` by iteratively reweighted least squares.
Fit fitColumns(const MatrixXd& terms, const VectorXd& weights, const std::vector<Index>& used) {
    const MatrixXd columns = terms(Eigen::all, used);
    const auto count = static_cast<double>(terms.rows());
    VectorXd solution, trust = VectorXd::Ones(terms.rows());
    VectorXd deviation;
    for (int round = 0; round < 12; ++round) {
        const VectorXd root = (weights.array() * trust.array()).sqrt();
        solution = (root.asDiagonal() * columns).colPivHouseholderQr().solve(root);
        if (solution.minCoeff() < 0)
            return {};
        // In logarithms, a decay twice as fast deviates as much as one half as fast.
        deviation = (columns * solution).array().max(1e-9).log().abs();
        trust = (usualDeviation / deviation.array().max(usualDeviation));
    }
    Fit fit{.law = VectorXd::Zero(terms.cols())};
    fit.law(used) = solution;
    const double spread =
        (weights.array() * trust.array() * deviation.array().square()).sum() / weights.sum();
    fit.criterion = count * std::log(spread + leastDeviation * leastDeviation) +
                    static_cast<double>(used.size()) * std::log(count + 1);
    return fit;
}

} // namespace

DampingLaw fittedDamping(std::span<const DecayOfMode> decays) {
    if (decays.empty())
        return {};
    MatrixXd terms(decays.size(), 3);
    VectorXd weights(decays.size());
    for (std::size_t i = 0; i < decays.size(); ++i) {
        const auto& [eigenvalue, decay, weight] = decays[i];
        terms.row(static_cast<Index>(i)) << 1, std::sqrt(eigenvalue), eigenvalue;
        terms.row(static_cast<Index>(i)) /= 2 * decay;
        weights(static_cast<Index>(i)) = weight;
    }
    const Eigen::RowVector3d scale = terms.colwise().norm();
    terms *= scale.cwiseInverse().asDiagonal();
    Fit best;
    for (unsigned subset = 1; subset < 8; ++subset) {
        std::vector<Index> used;
        for (Index term = 0; term < 3; ++term)
            if ((subset >> term & 1U) != 0)
                used.push_back(term);
        auto fit = fitColumns(terms, weights, used);
        if (fit.criterion < best.criterion)
            best = std::move(fit);
    }
    best.law.array() /= scale.transpose().array();
    return {.fluidPerSecond = best.law(0),
            .viscoelasticSeconds = best.law(2),
            .lossFactor = best.law(1)};
}

} // namespace idiophone
