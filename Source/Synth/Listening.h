// What of a mode's motion is heard: near, the velocity at the point that is struck; from afar, what
// the whole surface radiates, where the object knows.
#pragma once

#include "Object/ModalObject.h"
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

/// What an object's radiation weights w are multiplied by beside the shapes φ, so that it is as
/// loud from afar as near, and one whose parts cancel one another is not lost: the ratio of what
/// rings on after blows all over the surface, √(Σ a⁴/α / Σ a² w²/α) with a² the mean of |φ|² over
/// the surface, α the decay and w the mean over left and right, all at the object's own size and
/// material, but at most what leaves no weight beyond `largestShape`. 0 without weights. Takes
/// time: not for the audio thread.
double radiationScale(const ModalObject& object);

} // namespace idiophone
