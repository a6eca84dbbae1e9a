#include "Analysis/NoiseFloor.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace idiophone {

NoiseFloor::NoiseFloor(std::span<const double> noise, double sampleRateHz) {
    constexpr std::size_t shortest = 256, longest = 65536;
    if (noise.size() < shortest)
        return;
    const std::size_t length = std::min(std::bit_floor(noise.size()), longest);
    const auto last = noise.last(length);
    std::vector<double> windowed(length);
    double windowEnergy = 0;
    for (std::size_t n = 0; n < length; ++n) {
        const double turn = (static_cast<double>(n) + 0.5) / static_cast<double>(length);
        const double window = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * turn);
        windowed[n] = window * last[n];
        windowEnergy += window * window;
        mean += last[n] * last[n] / static_cast<double>(length);
    }
    std::vector<std::complex<double>> bins;
    Eigen::FFT<double> fft;
    fft.fwd(bins, windowed);
    binHz = sampleRateHz / static_cast<double>(length);
    for (std::size_t k = 0; k <= length / 2; ++k)
        energies.push_back(std::norm(bins[k]) / windowEnergy);
}

double NoiseFloor::energyAt(double hz) const {
    constexpr double reachShare = 0.12;
    constexpr double minimumBins = 4;
    if (energies.empty())
        return 0;
    const double place = hz / binHz, reach = std::max(minimumBins, reachShare * place);
    const auto last = static_cast<double>(energies.size() - 1);
    const auto first = static_cast<std::ptrdiff_t>(std::clamp(place - reach, 0.0, last));
    const auto until = static_cast<std::ptrdiff_t>(std::clamp(place + reach, 0.0, last)) + 1;
    std::vector<double> near(energies.begin() + first, energies.begin() + until);
    const auto middle = near.begin() + static_cast<std::ptrdiff_t>(near.size() / 2);
    std::ranges::nth_element(near, middle);
    return *middle / std::numbers::ln2; // the mean of an exponential distribution from its median
}

} // namespace idiophone
