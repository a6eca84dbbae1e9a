// The asymmetry of real bodies: no cast bell or thrown bowl is as round as its mesh, so its pairs
// of equal modes part, and warble.
#pragma once

#include "Object/ModalObject.h"

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

namespace idiophone {

/// A pair of modes of one frequency, with the two shapes that keep to themselves once mass is added
/// somewhere: those at hand turned by an angle.
struct ModePair {
    std::int32_t first = 0; ///< the other one is the next
    float cosine = 1, sine = 0;
    float part = 0; ///< of the imperfection, 0.5 to 1: how far this pair parts
};

/// The pairs of an object: neighbours within 0.05 % in frequency, but not the two modes that a bar
/// shares with its tube. Angles and parts are drawn from `seed`, so that a render repeats and no
/// two keys are alike. Allocates.
std::vector<ModePair> modePairs(const ModalObject& object, std::uint32_t seed);

/// First-order perturbation of the mass: of each pair one eigenvalue falls and the other rises, so
/// that their frequencies part by `imperfection` times its part. Any thread.
void partPairs(std::span<const ModePair> pairs,
               double imperfection,
               std::span<double> eigenvalues) noexcept;

/// Turns what belongs to the shapes of each pair, such as gains or weights. Any thread.
template <class Value>
void turnPairs(std::span<const ModePair> pairs, std::span<Value> ofModes) noexcept {
    for (const ModePair& pair : pairs) {
        Value& first = ofModes[static_cast<std::size_t>(pair.first)];
        Value& second = ofModes[static_cast<std::size_t>(pair.first) + 1];
        const Value turned = pair.cosine * first + pair.sine * second;
        second = pair.cosine * second - pair.sine * first;
        first = turned;
    }
}

} // namespace idiophone
