// What is heard of a mode's motion: near, the velocity of the struck point, or from afar, the
// pressure that the whole surface radiates, where the object knows it.
#pragma once

#include "Synth/Strike.h"

#include <array>

namespace idiophone {

/// What a contact microphone gives for the velocity of the struck point, in Pa per m/s: 1 Pa is
/// full scale, and so is 1 m/s (Raghuvanshi & Lin 2006 listen to velocity).
inline constexpr double contactMicrophonePascals = 1;

/// The direction ℓ along which the surface velocity at the struck point is heard: a mode's residue
/// for the impulse J at p is (φ(p)·J)(φ(p)·ℓ), which does not depend on the sign of φ or, summed
/// over equal poles, on their basis. ℓ points inwards, so that a strike straight into the surface
/// has no negative residue.
inline std::array<float, 3> listeningDirection(const StrikePoint& point) noexcept {
    return {-point.normal[0], -point.normal[1], -point.normal[2]};
}

} // namespace idiophone
