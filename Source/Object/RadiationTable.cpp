// SPDX-License-Identifier: Apache-2.0
#include "Object/RadiationTable.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace idiophone {
namespace {

bool isUnit(const std::array<float, 3>& direction) {
    // This comparison also refuses NaN.
    return std::abs(std::hypot(direction[0], direction[1], direction[2]) - 1) <= 1e-4f;
}

} // namespace

std::complex<float>
phasorBetween(std::complex<float> from, std::complex<float> to, float share) noexcept {
    const float fromSize = std::sqrt(std::norm(from)), toSize = std::sqrt(std::norm(to));
    const float size = fromSize + share * (toSize - fromSize);
    if (!(fromSize > 0) || !(toSize > 0))
        return from + share * (to - from);
    const std::complex<float> between = (1 - share) / fromSize * from + share / toSize * to;
    const float length = std::sqrt(std::norm(between));
    // Opposite phases have no shorter way.
    return length > 1e-6f ? size / length * between : size / toSize * to;
}

void RadiationTable::weightsAt(std::size_t direction,
                               double frequencyRatio,
                               std::span<std::complex<float>> modeWeights,
                               std::size_t firstMode) const noexcept {
    const std::size_t ratios = frequencyRatios.size();
    const std::size_t modes = weights.size() / directions.size() / ratios;
    const auto* const rows = weights.data() + direction * ratios * modes + firstMode;
    const auto scaled = [&](std::size_t ratio, float factor) {
        for (std::size_t mode = 0; mode < modeWeights.size(); ++mode)
            modeWeights[mode] = factor * rows[ratio * modes + mode];
    };
    if (!(frequencyRatio > frequencyRatios.front())) {
        const double below = frequencyRatio > 0 ? frequencyRatio / frequencyRatios.front() : 1;
        return scaled(0, static_cast<float>(below * below));
    }
    const auto above = std::ranges::lower_bound(frequencyRatios, frequencyRatio);
    if (above == frequencyRatios.end())
        return scaled(ratios - 1, 1);
    const auto upper = static_cast<std::size_t>(above - frequencyRatios.begin());
    if (*above == frequencyRatio)
        return scaled(upper, 1);
    const double below = frequencyRatios[upper - 1];
    const auto share =
        static_cast<float>(std::log(frequencyRatio / below) / std::log(*above / below));
    const auto *const from = rows + (upper - 1) * modes, *const to = rows + upper * modes;
    for (std::size_t mode = 0; mode < modeWeights.size(); ++mode)
        modeWeights[mode] = phasorBetween(from[mode], to[mode], share);
}

std::optional<std::size_t>
RadiationTable::directionTowards(const std::array<float, 3>& listener) const noexcept {
    if (directions.size() <= 2)
        return std::nullopt;
    const auto cosine = [&](const std::array<float, 3>& direction) {
        return direction[0] * listener[0] + direction[1] * listener[1] + direction[2] * listener[2];
    };
    const auto nearest = std::ranges::max_element(directions, {}, cosine);
    return static_cast<std::size_t>(nearest - directions.begin());
}

std::string faultOf(const RadiationTable& table, std::size_t modeCount) {
    const auto directions = table.directions.size(), ratios = table.frequencyRatios.size();
    if (directions == 0 && ratios == 0 && table.weights.empty())
        return {};
    // Divide instead of multiplying, so that a hostile size cannot wrap around.
    if (directions == 0 || ratios == 0 || modeCount == 0 || table.weights.empty() ||
        table.weights.size() % modeCount != 0 || table.weights.size() / modeCount % ratios != 0 ||
        table.weights.size() / modeCount / ratios != directions)
        return "the size of the radiation is not directions x ratios x modes";
    if (!std::ranges::all_of(table.directions, isUnit))
        return "a direction of the radiation is not a unit vector";
    const auto isInRange = [](double ratio) { return ratio >= 1e-6 && ratio <= 1e6; };
    if (!std::ranges::all_of(table.frequencyRatios, isInRange))
        return "a frequency ratio of the radiation is not between 1e-6 and 1e6";
    if (std::ranges::adjacent_find(table.frequencyRatios, std::greater_equal{}) !=
        table.frequencyRatios.end())
        return "the frequency ratios of the radiation are not in ascending order";
    // A mountain that moves at 1 m/s radiates less. All results stay finite in single precision.
    if (!std::ranges::all_of(table.weights,
                             [](std::complex<float> w) { return std::abs(w) <= 1e8f; }))
        return "a weight of the radiation is not a number up to 1e8 Pa·m";
    return {};
}

} // namespace idiophone
