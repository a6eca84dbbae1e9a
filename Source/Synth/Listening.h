// What of a mode's motion is heard. For now an object is heard at the point where it is struck;
// once radiation is computed, its directions replace this one function.
#pragma once

#include "Synth/Strike.h"

#include <array>

namespace idiophone {

/// The direction ℓ along which the surface velocity at the struck point is heard: a mode's residue
/// for the impulse J at p is (φ(p)·J)(φ(p)·ℓ), which does not depend on the sign of φ or, summed
/// over equal poles, on their basis. ℓ points inwards, so that a strike straight into the surface
/// has no negative residue.
inline std::array<float, 3> listeningDirection(const StrikePoint& point) noexcept {
    return {-point.normal[0], -point.normal[1], -point.normal[2]};
}

} // namespace idiophone
