#include "Analysis/ZoomedBand.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

using Eigen::Index;
using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
constexpr double samplesPerWidth = 1.8;
constexpr double halfLength = 2.5; // of the filter, in 1/width
constexpr double cutoff = 0.86;    // in widths
constexpr std::size_t steps = 4097;

/// I₀ for |x| < 10 by its power series, summed from the smallest term. Not every standard library
/// has std::cyl_bessel_i.
double modifiedBessel0(double x) {
    double sum = 1;
    for (int k = 40; k > 0; --k)
        sum = 1 + sum * (x * x / 4) / (k * k);
    return sum;
}

} // namespace

ZoomedBand::ZoomedBand(double centreHz, double widthHz)
    : centre(centreHz), width(widthHz), step(1 / (samplesPerWidth * widthHz)),
      reach(halfLength / widthHz), table(steps) {
    constexpr double kaiserBeta = 5.65;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double share = static_cast<double>(i) / (steps - 1);
        const double window =
            modifiedBessel0(kaiserBeta * std::sqrt(std::max(0.0, 1 - share * share))) /
            modifiedBessel0(kaiserBeta);
        const double angle = 2 * pi * cutoff * halfLength * share;
        table[i] = 2 * cutoff * width * window * (i > 0 ? std::sin(angle) / angle : 1);
    }
}

Index ZoomedBand::countIn(double seconds) const {
    return static_cast<Index>((seconds - 2 * reach) / step);
}

double ZoomedBand::noiseEnergy(double sampleRateHz) const {
    return 2 * cutoff * width / sampleRateHz;
}

double ZoomedBand::filterAt(double seconds) const {
    const double place = std::abs(seconds) / reach * (steps - 1);
    const auto i = static_cast<std::size_t>(place);
    if (i + 1 >= table.size())
        return 0;
    const double share = place - static_cast<double>(i);
    return table[i] + share * (table[i + 1] - table[i]);
}

Eigen::VectorXcd ZoomedBand::of(const DecayRecording& recording, Index count) const {
    const double rate = recording.sampleRateHz;
    const auto length = std::min(
        recording.samples.size(),
        static_cast<std::size_t>((2 * reach + step * static_cast<double>(count)) * rate) + 1);
    Eigen::VectorXd cosines(length), sines(length);
    const Complex turn = std::polar(1.0, -2 * pi * centre / rate);
    Complex phase = 1;
    for (std::size_t n = 0; n < length; ++n) {
        cosines(n) = recording.samples[n] * phase.real();
        sines(n) = recording.samples[n] * phase.imag();
        phase *= turn;
    }
    Eigen::VectorXcd result(count);
    for (Index m = 0; m < count; ++m) {
        const double instant = reach + step * static_cast<double>(m);
        const auto first = static_cast<std::size_t>(std::max(0.0, (instant - reach) * rate));
        const auto until = std::min(length, static_cast<std::size_t>((instant + reach) * rate) + 1);
        double real = 0, imaginary = 0;
        for (std::size_t n = first; n < until; ++n) {
            const double weight = filterAt(static_cast<double>(n) / rate - instant) / rate;
            real += weight * cosines(n);
            imaginary += weight * sines(n);
        }
        result(m) = {real, imaginary};
    }
    return result;
}

} // namespace idiophone
