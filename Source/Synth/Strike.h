// One contact between something hard and an object: where, how hard and for how long.
#pragma once

#include <array>
#include <cstdint>

namespace idiophone {

/// A place on an object's surface as a weighted mean of up to three vertices that carry shapes.
struct StrikePoint {
    std::array<std::int32_t, 3> shapeRows{0, 0, 0}; ///< rows of ModalObject::shapeVertices
    std::array<float, 3> weights{1, 0, 0};          ///< sum to 1; rows of weight 0 are not read
    std::array<float, 3> normal{0, 0, 1};           ///< unit outward normal

    bool operator==(const StrikePoint&) const = default;
};

/// A raised-cosine force pulse f(t) = (I/T)(1 − cos 2πt/T), 0 ≤ t ≤ T, or an ideal impulse.
struct Strike {
    StrikePoint point;
    std::array<float, 3> impulseNewtonSeconds{0, 0, 0}; ///< I, pointing into the object
    double durationSeconds = 0; ///< contact time T; 0 is the papers' ideal impulse
};

} // namespace idiophone
