#include "Instrument/ReleaseFade.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr int fewestSamples = 16;
constexpr double nothing = 1e-9; // remainder that is only rounding

} // namespace

ReleaseFade::ReleaseFade(double sampleRateHz)
    // Time that remains after the longest wait for a grid point.
    : samples(
          std::max(fewestSamples, static_cast<int>(seconds * sampleRateHz) - (cellSamples - 1))) {}

void ReleaseFade::apply(double left, std::span<float, cellSamples> newtons) const noexcept {
    for (float& force : newtons) {
        left = std::max(left - 1.0 / samples, 0.0);
        force *= static_cast<float>((1 - std::cos(std::numbers::pi * left)) / 2);
    }
}

double ReleaseFade::after(double left) const noexcept {
    const double later = left - static_cast<double>(cellSamples) / samples;
    return later < nothing ? 0 : later;
}

} // namespace idiophone
