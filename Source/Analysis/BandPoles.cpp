#include "Analysis/BandPoles.h"

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
constexpr double samplesPerWidth = 1.6;
constexpr Index longestBand = 256, longestStart = 640, minimumSamples = 24;
constexpr Index widestHankel = 96, widestStartHankel = 240;
// Minimum energy of a pole in the signal space. The first figure is relative to the noise, which
// spreads in a Hankel matrix. The second is relative to the maximum energy, against rounding
// errors.
constexpr double aboveNoise = 6, aboveRounding = 1e-13;
// The minimum energy that a pole explains in the recordings, over the noise energy of one value.
constexpr double energyOverNoise = 14;

/// I₀ for |x| < 10 by its power series, summed from the smallest term. Not every standard library
/// has std::cyl_bessel_i.
double modifiedBessel0(double x) {
    double sum = 1;
    for (int k = 40; k > 0; --k)
        sum = 1 + sum * (x * x / 4) / (k * k);
    return sum;
}

/// A low-pass of finite length: −6 dB at 0.8 widths, −90 dB from 1.1 on. It is a tabulated windowed
/// sinc, because the new samples lie anywhere between the old ones.
class BandFilter {
public:
    explicit BandFilter(double widthHz) : reach(halfLength / widthHz) {
        constexpr double cutoff = 0.8, kaiserBeta = 8.96;
        for (std::size_t i = 0; i < table.size(); ++i) {
            const double x = halfLength * static_cast<double>(i) / (steps - 1);
            const double share = x / halfLength;
            const double window =
                modifiedBessel0(kaiserBeta * std::sqrt(std::max(0.0, 1 - share * share))) /
                modifiedBessel0(kaiserBeta);
            const double angle = 2 * pi * cutoff * x;
            table[i] = 2 * cutoff * widthHz * window * (x > 0 ? std::sin(angle) / angle : 1);
        }
    }

    double reachSeconds() const { return reach; }

    double at(double seconds) const {
        const double place = std::abs(seconds) / reach * (steps - 1);
        const auto i = static_cast<std::size_t>(place);
        if (i + 1 >= table.size())
            return 0;
        const double share = place - static_cast<double>(i);
        return table[i] + share * (table[i + 1] - table[i]);
    }

private:
    static constexpr double halfLength = 4.7; ///< in 1/width
    static constexpr int steps = 4097;
    double reach;
    std::vector<double> table = std::vector<double>(steps);
};

/// Shifts a recording down by `centreHz`, filters it and returns the new samples.
template <class Taps>
VectorXcd zoomed(const DecayRecording& recording, const std::vector<Taps>& taps, double centreHz) {
    const Index length = taps.back().first + taps.back().weights.size();
    Eigen::VectorXd cosines(length), sines(length);
    const Complex turn = std::polar(1.0, -2 * pi * centreHz / recording.sampleRateHz);
    Complex phase = 1;
    for (Index n = 0; n < length; ++n) {
        const double sample = recording.samples[n];
        cosines(n) = sample * phase.real();
        sines(n) = sample * phase.imag();
        phase *= turn;
    }
    VectorXcd result(taps.size());
    for (std::size_t m = 0; m < taps.size(); ++m) {
        const Index first = taps[m].first, count = taps[m].weights.size();
        const Eigen::Map<const VectorXd> weights(taps[m].weights.data(), count);
        result(m) = {weights.dot(cosines.segment(first, count)),
                     weights.dot(sines.segment(first, count))};
    }
    return result;
}

/// Returns z of the exponentials z^m that the signals share. The number may be too high, but
/// is seldom too low.
VectorXcd commonExponentials(const std::vector<VectorXcd>& signals, Index widest) {
    const Index length = signals.front().size();
    const Index rows = std::min(length * 2 / 5, widest);
    MatrixXcd covariance = MatrixXcd::Zero(rows, rows);
    for (const auto& signal : signals) {
        MatrixXcd hankel(rows, length - rows + 1);
        for (Index column = 0; column < hankel.cols(); ++column)
            hankel.col(column) = signal.segment(column, rows);
        covariance.selfadjointView<Eigen::Lower>().rankUpdate(hankel);
    }
    const Eigen::SelfAdjointEigenSolver<MatrixXcd> solver(covariance);
    const VectorXd& energies = solver.eigenvalues(); // ascending
    const double noise = energies(rows / 4);
    const double faintest = std::max(aboveNoise * noise, aboveRounding * energies(rows - 1));
    Index order = 0;
    while (order < rows / 2 && energies(rows - 1 - order) > faintest)
        ++order;
    if (order == 0)
        return {};
    const MatrixXcd space = solver.eigenvectors().rightCols(order);
    const MatrixXcd upper = space.topRows(rows - 1), lower = space.bottomRows(rows - 1);
    const MatrixXcd rotation = (upper.adjoint() * upper).ldlt().solve(upper.adjoint() * lower);
    return Eigen::ComplexEigenSolver<MatrixXcd>(rotation, false).eigenvalues();
}

/// Fits all amplitudes together and marks the exponentials that explain more energy than the noise.
std::vector<bool> standOut(const std::vector<VectorXcd>& signals, const VectorXcd& exponentials) {
    const Index length = signals.front().size(), count = exponentials.size();
    MatrixXcd powers(length, count);
    powers.row(0).setOnes();
    for (Index m = 1; m < length; ++m)
        powers.row(m) = powers.row(m - 1).cwiseProduct(exponentials.transpose());
    const Eigen::ColPivHouseholderQR<MatrixXcd> solver(powers);
    VectorXd taken = VectorXd::Zero(count);
    double noise = 0;
    for (const auto& signal : signals) {
        const VectorXcd amplitudes = solver.solve(signal);
        noise += (signal - powers * amplitudes).squaredNorm();
        for (Index i = 0; i < count; ++i)
            taken(i) += std::norm(amplitudes(i)) * powers.col(i).squaredNorm();
    }
    const auto values = static_cast<double>(signals.size());
    noise /= values * static_cast<double>(std::max<Index>(1, length - count));
    std::vector<bool> result(count);
    for (Index i = 0; i < count; ++i)
        result[i] = taken(i) > energyOverNoise * (values + 1) * noise;
    return result;
}

/// Returns the exponentials that decay and stand out from the noise.
std::vector<Complex> audibleExponentials(const std::vector<VectorXcd>& signals, Index widest) {
    std::vector<Complex> result;
    if (signals.empty())
        return result;
    VectorXcd exponentials = commonExponentials(signals, widest);
    const auto damps = [](const Complex& z) { return std::abs(z) < 1 && std::abs(z) > 1e-6; };
    const auto damped = std::partition(exponentials.begin(), exponentials.end(), damps);
    exponentials.conservativeResize(damped - exponentials.begin());
    if (exponentials.size() == 0)
        return result;
    const auto chosen = standOut(signals, exponentials);
    for (Index i = 0; i < exponentials.size(); ++i)
        if (chosen[i])
            result.push_back(exponentials(i));
    return result;
}

} // namespace

BandPoles::BandPoles(std::span<const DecayRecording> of, double widthHz)
    : recordings(of), width(widthHz), step(1 / (samplesPerWidth * widthHz)) {
    const BandFilter filter(width);
    const double reach = filter.reachSeconds();
    double shortest = recordings.front().seconds();
    for (const auto& recording : recordings)
        shortest = std::min(shortest, recording.seconds());
    const double room = (shortest - 2 * reach) / step;
    if (room < static_cast<double>(minimumSamples))
        return;
    const auto count = static_cast<std::size_t>(std::min(room, static_cast<double>(longestBand)));
    for (const auto& recording : recordings) {
        const double rate = recording.sampleRateHz;
        auto& own = taps.emplace_back(count);
        for (std::size_t m = 0; m < count; ++m) {
            const double instant = reach + step * static_cast<double>(m);
            own[m].first = static_cast<std::size_t>(std::max(0.0, (instant - reach) * rate));
            const auto until = std::min(recording.samples.size(),
                                        static_cast<std::size_t>((instant + reach) * rate) + 1);
            for (std::size_t n = own[m].first; n < until; ++n)
                own[m].weights.push_back(filter.at(static_cast<double>(n) / rate - instant) / rate);
        }
    }
}

std::vector<DecayPole> BandPoles::polesAbout(double centreHz, double fastestDecayPerSecond) const {
    std::vector<VectorXcd> signals;
    for (std::size_t r = 0; r < taps.size(); ++r)
        signals.push_back(zoomed(recordings[r], taps[r], centreHz));
    std::vector<DecayPole> poles;
    for (const Complex& exponential : audibleExponentials(signals, widestHankel)) {
        const Complex pole = std::log(exponential) / step;
        const double offsetHz = pole.imag() / (2 * pi);
        if (std::abs(offsetHz) <= 0.505 * width && -pole.real() <= fastestDecayPerSecond)
            poles.push_back({.frequencyHz = centreHz + offsetHz, .decayPerSecond = -pole.real()});
    }
    return poles;
}

std::vector<DecayPole> polesOfStart(std::span<const DecayRecording> recordings) {
    // Only recordings of one rate have samples at the same instants. Ignore the others.
    const double rate = recordings.front().sampleRateHz;
    Index count = longestStart;
    for (const auto& recording : recordings)
        if (recording.sampleRateHz == rate)
            count = std::min(count, static_cast<Index>(recording.samples.size()));
    std::vector<VectorXcd> signals;
    for (const auto& recording : recordings)
        if (recording.sampleRateHz == rate)
            signals.push_back(
                Eigen::Map<const VectorXd>(recording.samples.data(), count).cast<Complex>());
    std::vector<DecayPole> poles;
    for (const Complex& exponential : audibleExponentials(signals, widestStartHankel)) {
        const Complex pole = std::log(exponential) * rate;
        if (pole.imag() > 0)
            poles.push_back(
                {.frequencyHz = pole.imag() / (2 * pi), .decayPerSecond = -pole.real()});
    }
    return poles;
}

} // namespace idiophone
