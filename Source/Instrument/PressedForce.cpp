#include "Instrument/PressedForce.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace idiophone {
namespace {

constexpr int minimumSamples = 16;
constexpr double nothing = 1e-9; // remainder that is only rounding

} // namespace

PressedForce::PressedForce(const std::shared_ptr<const SurfaceProfile>& profile, std::uint64_t seed)
    : force(profile, seed),
      // Time that remains after the longest wait for a grid point.
      fadeSamples(
          std::max(minimumSamples,
                   static_cast<int>(fadeSeconds * profile->sampleRateHz()) - (cellSamples - 1))) {}

void PressedForce::begin() noexcept {
    force.reset();
    remaining = 1;
    isReleased = false;
    isFresh = true;
}

void PressedForce::end() noexcept {
    force.reset();
    remaining = 0;
}

bool PressedForce::render(const ContactMotion& motion,
                          double nextGain,
                          std::span<float, cellSamples> newtons) noexcept {
    const bool presses = force.render(motion, newtons);
    const auto start = static_cast<float>(std::exchange(isFresh, false) ? nextGain : gain);
    gain = nextGain;
    const auto step = (static_cast<float>(gain) - start) / cellSamples;
    for (std::size_t i = 0; i < newtons.size(); ++i)
        newtons[i] *= start + static_cast<float>(i + 1) * step;
    if (!isReleased)
        return presses;
    double left = remaining;
    for (float& newton : newtons) {
        left = std::max(left - 1.0 / fadeSamples, 0.0);
        newton *= static_cast<float>((1 - std::cos(std::numbers::pi * left)) / 2);
    }
    remaining -= static_cast<double>(cellSamples) / fadeSamples;
    if (remaining < nothing)
        remaining = 0;
    return presses;
}

} // namespace idiophone
