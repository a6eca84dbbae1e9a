// SPDX-License-Identifier: Apache-2.0
#include "World/PlacedSource.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr double airHz = 10000;

/// Returns the pole p of the first-order low-pass y = (1 − p) x + p y₁ that has `gain` at a
/// frequency.
double poleFor(double gain, double radians) {
    if (gain >= 1)
        return 0;
    // |H|² = (1 − p)²/(1 − 2 p cos ω + p²), solved for p < 1.
    const double square = gain * gain;
    const double b = (1 - square * std::cos(radians)) / (1 - square);
    return b - std::sqrt(b * b - 1);
}

} // namespace

PlacedSource::PlacedSource(double sampleRateHz, std::size_t samplesOnTheWay)
    : rateHz(sampleRateHz), lineSize(std::bit_ceil(samplesOnTheWay + cellSamples)),
      line(lineSize + 2 * cellSamples), quietSamples(lineSize) {}

void PlacedSource::reset() noexcept {
    std::ranges::fill(line, 0.0f);
    position = 0;
    quietSamples = lineSize;
    isPlaced = false;
    airPole = air = 0;
    forget();
}

const float* PlacedSource::cellBefore(std::size_t samples) const noexcept {
    return line.data() + ((position - cellSamples - samples) & (lineSize - 1));
}

void PlacedSource::takeIn(std::span<const float, cellSamples> sound, float pole) noexcept {
    float last = air;
    for (std::size_t i = 0; i < cellSamples; ++i) {
        const float way = static_cast<float>(i + 1) / cellSamples;
        last += (1 - airPole - way * (pole - airPole)) * (sound[i] - last);
        const std::size_t place = (position + i) & (lineSize - 1);
        line[place] = last;
        if (place < line.size() - lineSize)
            line[lineSize + place] = last;
        quietSamples = sound[i] == 0 ? quietSamples + 1 : 0;
    }
    air = last;
    airPole = pole;
    position += cellSamples;
}

void PlacedSource::add(std::span<const float, cellSamples> sound,
                       const HeardPath& path,
                       const CellOutput& ears) noexcept {
    const auto pole = static_cast<float>(
        poleFor(path.airGain, std::min(2 * std::numbers::pi * airHz / rateHz, 3.0)));
    if (!isPlaced)
        airPole = pole;
    takeIn(sound, pole);
    hear(path, !isPlaced, ears);
    isPlaced = true;
    if (silent()) {
        air = 0;
        isPlaced = false;
        forget();
    }
}

} // namespace idiophone
