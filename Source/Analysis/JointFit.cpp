#include "Analysis/JointFit.h"

#include "Analysis/BackwardElimination.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

constexpr double ridge = 1e-10; // of products of columns of norm 1

/// e^x − 1 without cancellation.
Complex exponentialMinusOne(const Complex& x) {
    const double half = std::sin(0.5 * x.imag());
    return {std::expm1(x.real()) * std::cos(x.imag()) - 2 * half * half,
            std::exp(x.real()) * std::sin(x.imag())};
}

/// The sums of n^k e^{xn} over n < count, for k = 0, 1, 2. Each is the former's derivative by x.
struct PowerSums {
    PowerSums(const Complex& x, double count) {
        const Complex first = std::exp(x), last = std::exp(x * count);
        const Complex rest = -exponentialMinusOne(x);
        sums[0] = -exponentialMinusOne(x * count) / rest;
        sums[1] = (first * sums[0] - count * last) / rest;
        sums[2] = (first * (sums[0] + 2.0 * sums[1]) - count * count * last) / rest;
    }
    Complex sums[3];
};

/// One recording's normal equations. Mode i has the columns Re z^n and −Im z^n, whose factors are
/// the real and imaginary part of its amplitude, and n times these for a change of its pole.
struct NormalEquations {
    NormalEquations(const DecayRecording& recording,
                    const std::vector<DecayPole>& poles,
                    bool withSlopes)
        : modes(static_cast<Index>(poles.size())), rate(recording.sampleRateHz) {
        const Index parts = withSlopes ? 2 : 1;
        gram.resize(2 * modes * parts, 2 * modes * parts);
        right = VectorXd::Zero(2 * modes * parts);
        const auto count = static_cast<double>(recording.samples.size());
        for (Index i = 0; i < modes; ++i) {
            const Complex own = poles[i].perSecond() / rate;
            project(recording.samples, std::exp(own), i, withSlopes);
            for (Index j = 0; j <= i; ++j) {
                const Complex other = poles[j].perSecond() / rate;
                const PowerSums mixed(std::conj(own) + other, count), pure(own + other, count);
                for (Index k = 0; k < parts; ++k)
                    for (Index l = 0; l < parts; ++l)
                        setProducts(2 * (k * modes + i), 2 * (l * modes + j), mixed.sums[k + l],
                                    pure.sums[k + l]);
            }
        }
        for (const double sample : recording.samples)
            energy += sample * sample;
    }

    MatrixXd gram;
    VectorXd right;
    double energy = 0;
    Index modes;
    double rate;

private:
    void
    project(const std::vector<double>& samples, const Complex& z, Index mode, bool withSlopes) {
        constexpr double faintest = 1e-14; // −140 dB, of the energy
        double real = 1, imaginary = 0;
        double sums[4] = {};
        for (std::size_t n = 0; n < samples.size(); ++n) {
            const double x = samples[n], xn = x * static_cast<double>(n);
            sums[0] += x * real;
            sums[1] -= x * imaginary;
            sums[2] += xn * real;
            sums[3] -= xn * imaginary;
            const double turned = real * z.real() - imaginary * z.imag();
            imaginary = real * z.imag() + imaginary * z.real();
            real = turned;
            if (real * real + imaginary * imaginary < faintest)
                break;
        }
        right.segment<2>(2 * mode) << sums[0], sums[1];
        if (withSlopes)
            right.segment<2>(2 * (modes + mode)) << sums[2], sums[3];
    }

    /// `mixed` is the sum over conj(z_i) z_j and `pure` over z_i z_j.
    void setProducts(Index row, Index column, const Complex& mixed, const Complex& pure) {
        const Complex sum = 0.5 * (mixed + pure), difference = 0.5 * (mixed - pure);
        Eigen::Matrix2d block;
        block << sum.real(), -sum.imag(), difference.imag(), difference.real();
        gram.block<2, 2>(row, column) = block;
        gram.block<2, 2>(column, row) = block.transpose();
    }
};

/// The residual's energy with the best amplitudes, and how to lower it by a change of the poles.
struct PoleStep {
    double residual = 0;
    MatrixXd curvature; ///< over the real and imaginary part of each pole, per second
    VectorXd slope;
};

PoleStep poleStep(std::span<const DecayRecording> recordings, const std::vector<DecayPole>& poles) {
    const auto size = static_cast<Index>(2 * poles.size());
    PoleStep step{.curvature = MatrixXd::Zero(size, size), .slope = VectorXd::Zero(size)};
    for (const auto& recording : recordings) {
        const NormalEquations equations(recording, poles, true);
        const auto& gram = equations.gram;
        const VectorXd scale = gram.diagonal().head(size).cwiseSqrt().cwiseInverse();
        MatrixXd scaled = scale.asDiagonal() * gram.topLeftCorner(size, size) * scale.asDiagonal();
        scaled.diagonal().array() += ridge;
        const Eigen::LLT<MatrixXd> solver(scaled);
        const VectorXd amplitudes =
            scale.asDiagonal() * solver.solve(scale.asDiagonal() * equations.right.head(size));
        step.residual += equations.energy - amplitudes.dot(equations.right.head(size));
        const MatrixXd cross = scale.asDiagonal() * gram.topRightCorner(size, size);
        const MatrixXd inSpace = solver.matrixL().solve(cross);
        MatrixXd curvature = gram.bottomRightCorner(size, size);
        curvature.noalias() -= inSpace.transpose() * inSpace;
        const VectorXd slope =
            equations.right.tail(size) - gram.bottomLeftCorner(size, size) * amplitudes;
        // A pole's change d adds a d n z^n / rate.
        MatrixXd turned(size, size);
        std::vector<Eigen::Matrix2d> turns;
        for (Index i = 0; i < size; i += 2) {
            const double real = amplitudes(i) / equations.rate,
                         imaginary = amplitudes(i + 1) / equations.rate;
            turns.emplace_back() << real, -imaginary, imaginary, real;
            turned.middleCols<2>(i) = curvature.middleCols<2>(i) * turns.back();
            step.slope.segment<2>(i) += turns.back().transpose() * slope.segment<2>(i);
        }
        for (Index i = 0; i < size; i += 2)
            step.curvature.middleRows<2>(i) += turns[i / 2].transpose() * turned.middleRows<2>(i);
    }
    return step;
}

void sortByFrequency(std::vector<DecayPole>& poles) {
    std::ranges::sort(poles, {}, &DecayPole::frequencyHz);
}

} // namespace

JointFit::JointFit(std::span<const DecayRecording> of, std::vector<DecayPole> poles)
    : recordings(of), shared(std::move(poles)) {
    sortByFrequency(shared);
}

void JointFit::refine(int iterations) {
    constexpr double longestStep = 0.5, slowest = 0.05, settled = 1e-9;
    if (shared.empty())
        return;
    auto step = poleStep(recordings, shared);
    double reach = 1; // shorter after a step that failed
    for (int iteration = 0; iteration < iterations; ++iteration) {
        const VectorXd scale =
            (step.curvature.diagonal().array().max(1e-300)).sqrt().inverse().matrix();
        MatrixXd scaled = scale.asDiagonal() * step.curvature * scale.asDiagonal();
        scaled.diagonal().array() += 1e-6;
        const VectorXd change =
            scale.asDiagonal() * scaled.ldlt().solve(scale.asDiagonal() * step.slope);
        if (!change.allFinite())
            return;
        auto tried = shared;
        for (std::size_t i = 0; i < tried.size(); ++i) {
            auto& pole = tried[i];
            const Complex by(change(2 * i), change(2 * i + 1));
            const double limit = longestStep * std::max(pole.decayPerSecond, slowest);
            const Complex bounded =
                reach * by * std::min(1.0, limit / std::max(std::abs(by), 1e-300));
            pole.decayPerSecond = std::max(pole.decayPerSecond - bounded.real(), slowest);
            pole.frequencyHz += bounded.imag() / (2 * std::numbers::pi);
        }
        auto next = poleStep(recordings, tried);
        if (!(next.residual < step.residual)) {
            reach /= 4;
            continue;
        }
        const bool isSettled = step.residual - next.residual < settled * step.residual;
        shared = std::move(tried);
        step = std::move(next);
        if (isSettled)
            break;
    }
    sortByFrequency(shared);
}

void JointFit::eliminate(const MatrixXd& floors, std::size_t maximum) {
    if (shared.empty())
        return;
    BackwardElimination<double, 2> elimination;
    for (const auto& recording : recordings) {
        const NormalEquations equations(recording, shared, false);
        elimination.add(equations.gram, equations.right);
    }
    elimination.run(floors, static_cast<Index>(maximum));
    std::vector<DecayPole> kept;
    MatrixXd own(shared.size(), recordings.size());
    for (std::size_t i = 0; i < shared.size(); ++i)
        if (elimination.keeps(static_cast<Index>(i))) {
            for (std::size_t r = 0; r < recordings.size(); ++r)
                own(kept.size(), r) = elimination.ownEnergy(static_cast<Index>(i), r);
            kept.push_back(shared[i]);
        }
    energies = own.topRows(static_cast<Index>(kept.size()));
    shared = std::move(kept);
}

std::vector<DampedSinusoid> JointFit::sinusoids() const {
    std::vector<DampedSinusoid> result;
    for (const auto& pole : shared)
        result.push_back({.pole = pole, .amplitudes = {}});
    if (shared.empty())
        return result;
    for (const auto& recording : recordings) {
        const NormalEquations equations(recording, shared, false);
        BackwardElimination<double, 2> solver;
        solver.add(equations.gram, equations.right);
        for (std::size_t i = 0; i < result.size(); ++i) {
            const auto column = static_cast<Index>(2 * i);
            result[i].amplitudes.emplace_back(solver.factor(column, 0),
                                              solver.factor(column + 1, 0));
        }
    }
    return result;
}

std::vector<double> without(const DecayRecording& recording,
                            std::span<const DampedSinusoid> sinusoids,
                            std::size_t index) {
    auto rest = recording.samples;
    for (const auto& [pole, amplitudes] : sinusoids) {
        const Complex z = std::exp(pole.perSecond() / recording.sampleRateHz);
        Complex value = amplitudes[index];
        const double faintest = 1e-24 * std::norm(value);
        for (std::size_t n = 0; n < rest.size() && std::norm(value) > faintest; ++n) {
            rest[n] -= value.real();
            value *= z;
        }
    }
    return rest;
}

} // namespace idiophone
