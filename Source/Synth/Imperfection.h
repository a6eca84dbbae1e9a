// SPDX-License-Identifier: Apache-2.0
// The asymmetry of real bodies: no cast bell or thrown bowl is as round as its mesh. Each pair of
// equal modes splits in frequency and beats.
#pragma once

#include "Object/ModalObject.h"

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

namespace idiophone {

/// A pair of modes of equal frequency. The angle rotates their shapes to the two that stay
/// uncoupled when mass is added at one place.
struct ModePair {
    std::int32_t first = 0; ///< first mode; the second is the next one
    float cosine = 1, sine = 0;
    float splitting = 0; ///< in frequency, as a fraction of the imperfection, 0.5 to 1
};

/// Returns the pairs of an object: neighbours within 0.05 % in frequency, except the two modes that
/// a bar shares with its tube. Angles and shares are drawn from `seed`, so that renders repeat and
/// keys differ. Allocates.
std::vector<ModePair> modePairs(const ModalObject& object, std::uint32_t seed);

/// Splits each pair by first-order perturbation of the mass: one eigenvalue falls and the other
/// rises. Their frequencies differ by `imperfection` times the pair's splitting. Any thread.
void splitPairs(std::span<const ModePair> pairs,
                double imperfection,
                std::span<double> eigenvalues) noexcept;

/// Rotates values that belong to the shapes of each pair, such as gains or weights. Any thread.
template <class Value>
void rotatePairs(std::span<const ModePair> pairs, std::span<Value> ofModes) noexcept {
    for (const ModePair& pair : pairs) {
        Value& first = ofModes[static_cast<std::size_t>(pair.first)];
        Value& second = ofModes[static_cast<std::size_t>(pair.first) + 1];
        const Value turned = pair.cosine * first + pair.sine * second;
        second = pair.cosine * second - pair.sine * first;
        first = turned;
    }
}

} // namespace idiophone
