#include "Analysis/EchoedBand.h"

#include "Analysis/BackwardElimination.h"
#include "Analysis/ZoomedBand.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace idiophone {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

constexpr Index minimumSamples = 24, longestBand = 400;
constexpr double lowestCentre = 0.6; // in widths
constexpr double leastNoise = 1e-8;  // of the energy of the loudest sample

/// ∫ e^{xτ} dτ from 0 to t.
Complex integral(const Complex& x, double t) {
    constexpr double tiny = 1e-6;
    return std::abs(x * t) < tiny ? t * (1.0 + x * t / 2.0) : (std::exp(x * t) - 1.0) / x;
}

/// Unknowns that could have had any value of this size make a model less likely: by the determinant
/// of what the data say of them. Returns its logarithm.
double penalty(const MatrixXcd& columns, double size) {
    MatrixXcd information = size * size * columns.adjoint() * columns;
    information.diagonal().array() += 1;
    const MatrixXcd root = information.llt().matrixL();
    return 2 * root.diagonal().real().array().log().sum();
}

} // namespace

EchoedBand::EchoedBand(std::span<const RecordedStrike> strikes,
                       std::span<const DecayRecording> rests,
                       std::span<const DampedSinusoid> sinusoids,
                       const BandOfModes& band)
    : centreHz(band.centreHz), widthHz(band.widthHz), kept(band.modes), poles(kept.size()) {
    const ZoomedBand zoom(centreHz, widthHz);
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto& rest : rests)
        shortest = std::min(shortest, rest.seconds());
    count = std::min(zoom.countIn(shortest), longestBand);
    step = zoom.stepSeconds();
    first = zoom.firstSeconds();
    if (!isUsable())
        return;
    for (std::size_t i = 0; i < kept.size(); ++i)
        poles(static_cast<Index>(i)) =
            sinusoids[kept[i]].pole.perSecond() - Complex(0, 2 * std::numbers::pi * centreHz);
    for (std::size_t r = 0; r < rests.size(); ++r) {
        auto& strip = strips.emplace_back();
        strip.amplitudes.resize(poles.size());
        for (std::size_t i = 0; i < kept.size(); ++i)
            strip.amplitudes(static_cast<Index>(i)) = sinusoids[kept[i]].amplitudes[r] / 2.0;
        strip.samples = zoom.of(rests[r], count) + exponentials() * strip.amplitudes;
        strip.noise =
            strikes[r].noise.energyAt(centreHz) * zoom.noiseEnergy(rests[r].sampleRateHz) +
            leastNoise * strip.samples.cwiseAbs2().maxCoeff() + 1e-30;
    }
}

bool EchoedBand::isUsable() const {
    return count >= minimumSamples && centreHz > lowestCentre * widthHz;
}

double EchoedBand::fit(const RoomEchoes& room) {
    double likelihood = move(room);
    while (poles.size() > 1) {
        auto fewer = *this;
        fewer.remove(faintestMode(room));
        const double withFewer = fewer.move(room);
        if (withFewer < likelihood)
            break;
        *this = std::move(fewer);
        likelihood = withFewer;
    }
    return likelihood;
}

DecayPole EchoedBand::pole(std::size_t number) const {
    const Complex& own = poles(static_cast<Index>(number));
    return {.frequencyHz = centreHz + own.imag() / (2 * std::numbers::pi),
            .decayPerSecond = -own.real()};
}

/// Gauss-Newton, with shorter steps after one that failed.
double EchoedBand::move(const RoomEchoes& room) {
    constexpr int rounds = 6;
    constexpr double settled = 0.01, longestStep = 0.3; // of the decay
    evaluate(room);                                     // for amplitudes in this room
    auto now = evaluate(room);
    double reach = 1;
    for (int round = 0; round < rounds && now.change.allFinite(); ++round) {
        const auto before = *this;
        for (Index i = 0; i < poles.size(); ++i) {
            const Complex by = reach * now.change(i);
            const double limit = longestStep * std::abs(poles(i).real());
            poles(i) += by * std::min(1.0, limit / std::max(std::abs(by), 1e-300));
        }
        auto next = evaluate(room);
        if (!(next.likelihood > now.likelihood)) {
            *this = before;
            reach /= 4;
            continue;
        }
        const bool isSettled = next.likelihood - now.likelihood < settled;
        now = std::move(next);
        if (isSettled)
            break;
    }
    return now.likelihood;
}

/// Sets the best amplitudes.
EchoedBand::Evaluation EchoedBand::evaluate(const RoomEchoes& room) {
    const Index size = poles.size();
    MatrixXcd slopes(count * std::ssize(strips), size);
    VectorXcd rests(slopes.rows());
    Evaluation result;
    for (std::size_t r = 0; r < strips.size(); ++r) {
        auto& strip = strips[r];
        MatrixXcd columns(count, 2 * size + 1);
        columns.leftCols(size) = exponentials();
        for (Index i = 0; i < size; ++i)
            columns.col(size + i) = strip.amplitudes(i) * times().cwiseProduct(columns.col(i));
        columns.col(2 * size) = strip.samples;
        result.likelihood -= whiten(columns, strip, room);
        result.likelihood -=
            penalty(columns.leftCols(size), strip.amplitudes.cwiseAbs().maxCoeff());
        const Eigen::ColPivHouseholderQR<MatrixXcd> solver(columns.leftCols(size));
        strip.amplitudes = solver.solve(columns.col(2 * size));
        const MatrixXcd others = columns.rightCols(size + 1);
        const MatrixXcd free = others - columns.leftCols(size) * solver.solve(others);
        const Index row = count * static_cast<Index>(r);
        slopes.middleRows(row, count) = free.leftCols(size);
        rests.segment(row, count) = free.col(size);
    }
    result.likelihood -= rests.squaredNorm() + penalty(slopes, std::numbers::pi * widthHz / 2);
    result.change = slopes.colPivHouseholderQr().solve(rests);
    return result;
}

/// Whitens columns by a Kalman filter: each mode is a state that decays and that the echoes strike.
/// Returns the logarithm of the determinant of the covariance.
double EchoedBand::whiten(MatrixXcd& columns, const Strip& strip, const RoomEchoes& room) const {
    const Index size = poles.size();
    const double density = 2 * room.decayPerSecond * room.energy;
    // The covariance that earlier echoes leave at the first sample, and that each step adds.
    MatrixXcd covariance(size, size), added(size, size);
    for (Index i = 0; i < size; ++i)
        for (Index k = 0; k < size; ++k) {
            const Complex both = poles(i) + std::conj(poles(k));
            const Complex product = density * strip.amplitudes(i) * std::conj(strip.amplitudes(k));
            const Complex rate = -both - 2 * room.decayPerSecond;
            covariance(i, k) = product * std::exp(both * first) * integral(rate, first);
            added(i, k) = product * std::exp(both * step) * integral(rate, step);
        }
    const VectorXcd turns = (poles * step).array().exp();
    const double fall = std::exp(-2 * room.decayPerSecond * step);
    double strength = std::exp(-2 * room.decayPerSecond * first), logarithms = 0;
    MatrixXcd states = MatrixXcd::Zero(size, columns.cols());
    for (Index m = 0; m < count; ++m) {
        const VectorXcd heard = covariance.rowwise().sum();
        const double energy = heard.sum().real() + strip.noise;
        const VectorXcd gains = heard / energy;
        columns.row(m) -= states.colwise().sum();
        states += gains * columns.row(m);
        columns.row(m) /= std::sqrt(energy);
        logarithms += std::log(energy);
        covariance -= gains * heard.adjoint();
        states = turns.asDiagonal() * states;
        covariance = turns.asDiagonal() * covariance * turns.conjugate().asDiagonal();
        covariance += strength * added;
        strength *= fall;
    }
    return logarithms;
}

Index EchoedBand::faintestMode(const RoomEchoes& room) const {
    VectorXd own = VectorXd::Zero(poles.size());
    for (const auto& strip : strips) {
        MatrixXcd columns = exponentials();
        whiten(columns, strip, room);
        const MatrixXcd gram = columns.adjoint() * columns;
        BackwardElimination<Complex, 1> elimination;
        elimination.add(gram, gram * strip.amplitudes);
        for (Index i = 0; i < poles.size(); ++i)
            own(i) += elimination.ownEnergy(i, 0);
    }
    Index faintest = 0;
    own.minCoeff(&faintest);
    return faintest;
}

void EchoedBand::remove(Index mode) {
    const auto erase = [mode](VectorXcd& values) {
        const Index after = values.size() - mode - 1;
        values.segment(mode, after) = values.tail(after).eval();
        values.conservativeResize(mode + after);
    };
    kept.erase(kept.begin() + mode);
    erase(poles);
    for (auto& strip : strips)
        erase(strip.amplitudes);
}

VectorXcd EchoedBand::times() const {
    return VectorXd::LinSpaced(count, first, first + step * static_cast<double>(count - 1))
        .cast<Complex>();
}

MatrixXcd EchoedBand::exponentials() const {
    return (times() * poles.transpose()).array().exp().matrix();
}

} // namespace idiophone
