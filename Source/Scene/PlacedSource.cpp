#include "Scene/PlacedSource.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr double airHz = 10000;
// The cubic goes from one sample before to two behind.
constexpr double leastDelaySamples = 1;
constexpr std::size_t points = 4;

/// Of a first-order low-pass y = (1 − p) x + p y₁ whose gain at a frequency is this.
double poleFor(double gain, double radians) {
    if (gain >= 1)
        return 0;
    // |H|² = (1 − p)²/(1 − 2 p cos ω + p²), solved for the p < 1.
    const double square = gain * gain;
    const double b = (1 - square * std::cos(radians)) / (1 - square);
    return b - std::sqrt(b * b - 1);
}

/// ω₀ of the shadow in units of the sample rate, turned over.
double warping(double rateHz) {
    return rateHz / (2 * std::numbers::pi * headCornerHz());
}

} // namespace

PlacedSource::PlacedSource(double sampleRateHz)
    : rateHz(sampleRateHz),
      feedback(static_cast<float>((1 - warping(sampleRateHz)) / (1 + warping(sampleRateHz)))),
      lineSize(std::bit_ceil(static_cast<std::size_t>(HeadModel::longestDelaySeconds * rateHz) +
                             points + cellSamples)),
      quietSamples(lineSize) {
    line.resize(lineSize + cellSamples + points);
}

void PlacedSource::reset() noexcept {
    std::ranges::fill(line, 0.0f);
    position = 0;
    quietSamples = lineSize;
    isPlaced = false;
    airPole = air = 0;
    ears = {};
    memories = {};
}

/// The shadow by the bilinear transform.
PlacedSource::Ear PlacedSource::earOf(const EarPath& path, double gain) const noexcept {
    const double warped = warping(rateHz), alpha = path.highFrequencyGain;
    const double scale = gain / (1 + warped);
    const double delay = leastDelaySamples + path.delaySeconds * rateHz;
    const double d = delay - std::floor(delay);
    return {.delay = {.samples = static_cast<std::size_t>(delay) - 1,
                      .weights = {static_cast<float>(-d * (d - 1) * (d - 2) / 6),
                                  static_cast<float>((d + 1) * (d - 1) * (d - 2) / 2),
                                  static_cast<float>(-(d + 1) * d * (d - 2) / 2),
                                  static_cast<float>((d + 1) * d * (d - 1) / 6)}},
            .direct = static_cast<float>(scale * (1 + alpha * warped)),
            .previous = static_cast<float>(scale * (1 - alpha * warped))};
}

void PlacedSource::takeIn(std::span<const float, cellSamples> sound, float pole) noexcept {
    for (std::size_t i = 0; i < cellSamples; ++i) {
        const float way = static_cast<float>(i + 1) / cellSamples;
        air += (1 - airPole - way * (pole - airPole)) * (sound[i] - air);
        const std::size_t place = (position + i) & (lineSize - 1);
        line[place] = air;
        if (place < line.size() - lineSize)
            line[lineSize + place] = air;
        quietSamples = sound[i] == 0 ? quietSamples + 1 : 0;
    }
    airPole = pole;
    position += cellSamples;
}

void PlacedSource::delayed(const Delay& delay, std::span<float, cellSamples> to) const noexcept {
    // The oldest of the four points of the first sample.
    const std::size_t first =
        (position - cellSamples - delay.samples - (points - 1)) & (lineSize - 1);
    const float* from = line.data() + first;
    const auto& w = delay.weights;
    for (std::size_t i = 0; i < cellSamples; ++i)
        to[i] = w[3] * from[i] + w[2] * from[i + 1] + w[1] * from[i + 2] + w[0] * from[i + 3];
}

void PlacedSource::add(std::span<const float, cellSamples> sound,
                       const HeardPath& path,
                       const CellOutput& output) noexcept {
    const auto pole = static_cast<float>(
        poleFor(path.airGain, std::min(2 * std::numbers::pi * airHz / rateHz, 3.0)));
    if (!isPlaced)
        airPole = pole;
    takeIn(sound, pole);
    alignas(64) std::array<float, cellSamples> before, after;
    for (std::size_t side = 0; side < 2; ++side) {
        const Ear to = earOf(path.ears[side], path.gain);
        const Ear from = isPlaced ? ears[side] : to;
        Memory& memory = memories[side];
        delayed(from.delay, before);
        delayed(to.delay, after);
        for (std::size_t i = 0; i < cellSamples; ++i) {
            const float way = static_cast<float>(i + 1) / cellSamples;
            const float input = before[i] + way * (after[i] - before[i]);
            const float shadowed =
                (from.direct + way * (to.direct - from.direct)) * input +
                (from.previous + way * (to.previous - from.previous)) * memory.input -
                feedback * memory.output;
            memory = {.input = input, .output = shadowed};
            output[side][i] += shadowed;
        }
        ears[side] = to;
    }
    isPlaced = true;
    if (silent()) {
        memories = {};
        air = 0;
        isPlaced = false;
    }
}

} // namespace idiophone
