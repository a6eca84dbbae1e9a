#include "Analysis/ClusterFit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Prevents overflow in divisions by a value that may be 0.
constexpr double nothing = 1e-300;

/// Returns the variance of one part of complex values that are mostly noise. It is half their mean
/// power, which is their median power over ln 2.
double noiseOf(const VectorXd& parts) {
    std::vector<double> powers;
    for (Index k = 0; k < parts.size(); k += 2)
        powers.push_back(parts.segment<2>(k).squaredNorm());
    const auto middle = powers.begin() + static_cast<std::ptrdiff_t>(powers.size() / 2);
    std::nth_element(powers.begin(), middle, powers.end());
    return std::max(*middle / std::numbers::ln2 / 2, nothing);
}

void setParts(MatrixXd& matrix, Index k, Index column, const Complex& value) {
    matrix(2 * k, column) = value.real();
    matrix(2 * k + 1, column) = value.imag();
}

/// The fit of one piece. Rows are the real and imaginary parts of its bins. Columns are a cosine
/// and a sine of each mode, then the background.
class PieceFit {
public:
    PieceFit(std::span<const DecayPole> ofPoles, const SpectrumPiece& ofPiece, bool background)
        : poles(ofPoles), piece(ofPiece), modes(poles.size()), rows(piece.bins.size()),
          target(2 * rows), basis(MatrixXd::Zero(2 * rows, 2 * modes + (background ? 4 : 0))) {
        for (const auto& pole : poles)
            sinusoids.emplace_back(pole, piece.rateHz, piece.length);
        for (Index k = 0; k < rows; ++k) {
            const auto at = static_cast<std::size_t>(k);
            bins.push_back(conjugateBin(piece.firstBin + at, piece.length));
            target.segment<2>(2 * k) << piece.bins[at].real(), piece.bins[at].imag();
            for (Index i = 0; i < modes; ++i) {
                const auto& sinusoid = sinusoids[i];
                setParts(basis, k, 2 * i, sinusoid.at({1, 0}, bins.back()));
                setParts(basis, k, 2 * i + 1, sinusoid.at({0, 1}, bins.back()));
            }
            if (background)
                setBackground(k);
        }
        // Scale the columns, whose norms differ as the decay rates do.
        scale = basis.colwise().norm().cwiseMax(nothing).cwiseInverse().transpose();
        basis *= scale.asDiagonal();
        solver.compute(basis);
        const VectorXd turned = solver.householderQ().adjoint() * target;
        triangle = solver.matrixQR().topRows(basis.cols());
        scaled = triangle.triangularView<Eigen::Upper>().solve(turned.head(basis.cols()));
        residual = target - basis * scaled;
    }

    void addTo(ClusterFit& fit, std::size_t pieceNumber) const {
        fit.cost += residual.squaredNorm();
        for (Index i = 0; i < modes; ++i)
            fit.amplitudes[i][pieceNumber] = amplitude(i);
        addSlopes(fit);
        addSignificances(fit);
    }

private:
    Complex amplitude(Index mode) const {
        return {scaled(2 * mode) * scale(2 * mode), scaled(2 * mode + 1) * scale(2 * mode + 1)};
    }

    void setBackground(Index k) {
        const double place = 2.0 * static_cast<double>(k) / static_cast<double>(rows) - 1;
        basis(2 * k, 2 * modes) = basis(2 * k + 1, 2 * modes + 1) = 1;
        basis(2 * k, 2 * modes + 2) = basis(2 * k + 1, 2 * modes + 3) = place;
    }

    void addSlopes(ClusterFit& fit) const {
        MatrixXd slopes(2 * rows, 2 * modes);
        for (Index i = 0; i < modes; ++i) {
            const auto& sinusoid = sinusoids[i];
            const double decay = poles[i].decayPerSecond;
            for (Index k = 0; k < rows; ++k) {
                const Complex bin = bins[k];
                const Complex up = 0.5 * amplitude(i) * sinusoid.up.slopeAt(bin);
                const Complex down = 0.5 * std::conj(amplitude(i)) * sinusoid.down.slopeAt(bin);
                // The poles are −α ± iω.
                setParts(slopes, k, 2 * i, Complex(0, 1) * (up - down));
                setParts(slopes, k, 2 * i + 1, -decay * (up + down));
            }
        }
        fit.slope += slopes.transpose() * residual;
        const MatrixXd inSpace = (solver.householderQ().adjoint() * slopes).topRows(basis.cols());
        fit.curvature += slopes.transpose() * slopes - inSpace.transpose() * inSpace;
    }

    void addSignificances(ClusterFit& fit) const {
        const double noise = noiseOf(residual);
        const MatrixXd inverse = triangle.triangularView<Eigen::Upper>().solve(
            MatrixXd::Identity(basis.cols(), basis.cols()));
        const MatrixXd covariance = inverse * inverse.transpose();
        for (Index i = 0; i < modes; ++i) {
            const Eigen::Vector2d own = scaled.segment<2>(2 * i);
            const Eigen::Matrix2d block = covariance.block<2, 2>(2 * i, 2 * i);
            fit.significances[i] += own.dot(block.inverse() * own) / noise;
        }
    }

    std::span<const DecayPole> poles;
    const SpectrumPiece& piece;
    Index modes, rows;
    std::vector<CutSinusoid> sinusoids;
    std::vector<Complex> bins;
    VectorXd target;
    MatrixXd basis; ///< scaled to columns of norm 1
    VectorXd scale, scaled, residual;
    Eigen::HouseholderQR<MatrixXd> solver;
    MatrixXd triangle; ///< only the upper half is used
};

/// Returns a pole after a step, limited to the allowed distance from its origin.
DecayPole
moved(const DecayPole& pole, const DecayPole& origin, double binHz, double upHz, double faster) {
    constexpr double maximumDecay = 4, maximumWidths = 3, maximumBins = 3, lowestHz = 10;
    const double reach = maximumWidths * origin.widthHz() + maximumBins * binHz;
    const double lowest = std::max(origin.frequencyHz - reach, lowestHz);
    return {.frequencyHz = std::clamp(pole.frequencyHz + upHz, lowest,
                                      std::max(lowest, origin.frequencyHz + reach)),
            .decayPerSecond = std::clamp(pole.decayPerSecond * std::exp(faster),
                                         origin.decayPerSecond / maximumDecay,
                                         origin.decayPerSecond * maximumDecay)};
}

} // namespace

CutExponential::CutExponential(const Complex& polePerSecond, double rateHz, std::size_t length)
    : z(std::exp(polePerSecond / rateHz)),
      last(std::exp(polePerSecond / rateHz * static_cast<double>(length))), rate(rateHz),
      size(static_cast<double>(length)) {}

Complex CutExponential::slopeAt(const Complex& conjugateBin) const {
    const Complex turned = z * conjugateBin, rest = 1.0 - turned;
    return ((1.0 - last) * turned / rest - size * last) / rest / rate;
}

Complex conjugateBin(std::size_t k, std::size_t length) {
    return std::polar(1.0,
                      -2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(length));
}

ClusterFit fitCluster(std::span<const DecayPole> poles,
                      std::span<const SpectrumPiece> pieces,
                      bool background) {
    const auto unknowns = static_cast<Index>(2 * poles.size());
    ClusterFit fit{.cost = 0,
                   .curvature = MatrixXd::Zero(unknowns, unknowns),
                   .slope = VectorXd::Zero(unknowns),
                   .amplitudes = std::vector(poles.size(), std::vector<Complex>(pieces.size())),
                   .significances = std::vector<double>(poles.size(), 0)};
    const std::size_t columns = 2 * poles.size() + (background ? 4 : 0);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (2 * pieces[i].bins.size() > columns)
            PieceFit(poles, pieces[i], background).addTo(fit, i);
    // Keep the pole of a mode without amplitude, which has no curvature.
    fit.curvature.diagonal().array() += nothing;
    return fit;
}

ClusterFit refineCluster(std::vector<DecayPole>& poles,
                         std::span<const DecayPole> origins,
                         std::span<const SpectrumPiece> pieces,
                         bool background) {
    constexpr int iterations = 12;
    constexpr double settledStep = 1e-7; // in ln α, and in widths
    const double binHz = pieces.front().rateHz / static_cast<double>(pieces.front().length);
    ClusterFit best = fitCluster(poles, pieces, background);
    double caution = 1e-3;
    for (int iteration = 0; iteration < iterations && caution < 1e6; ++iteration) {
        MatrixXd curvature = best.curvature;
        curvature.diagonal() *= 1 + caution;
        const VectorXd step = curvature.ldlt().solve(best.slope);
        if (!step.allFinite())
            break;
        auto tried = poles;
        double largest = 0;
        for (std::size_t i = 0; i < poles.size(); ++i) {
            // Limit a step to a few widths: the slope says nothing about poles farther away.
            const double reach = 2 * std::max(poles[i].widthHz(), binHz);
            const double up = std::clamp(step(2 * i) / (2 * std::numbers::pi), -reach, reach);
            const double faster = std::clamp(step(2 * i + 1), -1.2, 1.2);
            tried[i] = moved(poles[i], origins[i], binHz, up, faster);
            largest = std::max({largest, std::abs(faster), std::abs(up) / poles[i].widthHz()});
        }
        auto fit = fitCluster(tried, pieces, background);
        const bool isBetter = fit.cost < best.cost;
        if (isBetter) {
            poles = std::move(tried);
            best = std::move(fit);
        }
        if (largest < settledStep)
            break;
        caution = isBetter ? std::max(caution / 10, 1e-9) : 10 * caution;
    }
    return best;
}

} // namespace idiophone
