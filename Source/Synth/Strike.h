// SPDX-License-Identifier: Apache-2.0
// The strike of a hard body on an object: place, impulse and duration.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace idiophone {

/// The corners of two faces, for a place between two points of a path.
inline constexpr std::size_t maximumShapeRows = 6;

/// A place on an object's surface, as a weighted mean of a few vertices that carry shapes.
struct StrikePoint {
    std::array<std::int32_t, maximumShapeRows> shapeRows{}; ///< rows of ModalObject::shapeVertices
    std::array<float, maximumShapeRows> weights{1}; ///< sum to 1; rows of weight 0 are not read
    /// The outward normal, of length 1 (not checked). The near sound is the velocity of the point
    /// along it, so a wrong normal is heard too softly.
    std::array<float, 3> normal{0, 0, 1};
    /// The direction of the far sound: an index in the object's RadiationTable for all channels. At
    /// −1 each channel has its own direction.
    std::int32_t radiationDirection = -1;

    bool operator==(const StrikePoint&) const = default;
};

/// A raised-cosine force pulse f(t) = (I/T)(1 − cos 2πt/T), 0 ≤ t ≤ T, or an ideal impulse.
struct Strike {
    StrikePoint point;
    std::array<float, 3> impulseNewtonSeconds{0, 0, 0}; ///< I, pointing into the object
    double durationSeconds = 0; ///< contact time T; 0 is the ideal impulse of the papers
};

/// Shorter pulses are played as impulses: within the band they are equal, and their force would
/// alias.
inline constexpr double shortestContactSamples = 2;

} // namespace idiophone
