// SPDX-License-Identifier: Apache-2.0
#include "Synth/Imperfection.h"

#include <cmath>
#include <numbers>
#include <random>

namespace idiophone {

std::vector<ModePair> modePairs(const ModalObject& object, std::uint32_t seed) {
    constexpr double pairRatio = 1.001; // of eigenvalues: 0.05 % in frequency
    std::vector<ModePair> pairs;
    std::mt19937 random(seed); // differs from the first number on, even for small seeds
    const auto drawn = [&random] { return static_cast<float>(random() / 4294967296.0); };
    for (std::size_t mode = 0; mode + 1 < object.modeCount(); ++mode) {
        const bool isShared = object.isShared(mode) || object.isShared(mode + 1);
        if (isShared || object.eigenvalues[mode + 1] > pairRatio * object.eigenvalues[mode])
            continue;
        const float angle = std::numbers::pi_v<float> * drawn();
        pairs.push_back({.first = static_cast<std::int32_t>(mode),
                         .cosine = std::cos(angle),
                         .sine = std::sin(angle),
                         .splitting = (1 + drawn()) / 2});
        ++mode;
    }
    return pairs;
}

void splitPairs(std::span<const ModePair> pairs,
                double imperfection,
                std::span<double> eigenvalues) noexcept {
    for (const ModePair& pair : pairs) {
        // Half of the splitting on either side, and twice that in eigenvalues.
        const double change = imperfection * static_cast<double>(pair.splitting);
        eigenvalues[static_cast<std::size_t>(pair.first)] *= 1 - change;
        eigenvalues[static_cast<std::size_t>(pair.first) + 1] *= 1 + change;
    }
}

} // namespace idiophone
