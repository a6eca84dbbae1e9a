// SPDX-License-Identifier: Apache-2.0
#include "World/SphereSource.h"

#include <cmath>

namespace idiophone {
namespace {

// The cubic uses one sample before and two after.
constexpr double minimumDelaySamples = 1;
constexpr std::size_t points = 4;

} // namespace

SphereSource::SphereSource(double sampleRateHz)
    : PlacedSource(sampleRateHz,
                   static_cast<std::size_t>(HeadModel::longestDelaySeconds * sampleRateHz) +
                       points),
      rateHz(sampleRateHz), feedback(static_cast<float>(headShadow(1, sampleRateHz).feedback)) {}

void SphereSource::forget() noexcept {
    ears = {};
    memories = {};
}

SphereSource::Ear SphereSource::earOf(const EarPath& path, double gain) const noexcept {
    const auto shadow = headShadow(path.highFrequencyGain, rateHz);
    const double delay = minimumDelaySamples + path.delaySeconds * rateHz;
    const double d = delay - std::floor(delay);
    return {.delay = {.samples = static_cast<std::size_t>(delay) - 1,
                      .weights = {static_cast<float>(-d * (d - 1) * (d - 2) / 6),
                                  static_cast<float>((d + 1) * (d - 1) * (d - 2) / 2),
                                  static_cast<float>(-(d + 1) * d * (d - 2) / 2),
                                  static_cast<float>((d + 1) * d * (d - 1) / 6)}},
            .direct = static_cast<float>(gain * shadow.direct),
            .previous = static_cast<float>(gain * shadow.previous)};
}

void SphereSource::delayed(const Delay& delay, std::span<float, cellSamples> to) const noexcept {
    const float* from = cellBefore(delay.samples + points - 1); // oldest of the four samples
    const auto& w = delay.weights;
    for (std::size_t i = 0; i < cellSamples; ++i)
        to[i] = w[3] * from[i] + w[2] * from[i + 1] + w[1] * from[i + 2] + w[0] * from[i + 3];
}

void SphereSource::hear(const HeardPath& path, bool isFirst, const CellOutput& output) noexcept {
    alignas(64) std::array<float, cellSamples> before, after;
    for (std::size_t side = 0; side < 2; ++side) {
        const Ear to = earOf(path.ears[side], path.gain);
        const Ear from = isFirst ? to : ears[side];
        Memory memory = memories[side];
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
        memories[side] = memory;
        ears[side] = to;
    }
}

} // namespace idiophone
