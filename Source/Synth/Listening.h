// SPDX-License-Identifier: Apache-2.0
// How a mode's motion is heard: near, as the velocity of the struck point; or far, as the pressure
// that the whole surface radiates, if the object has a radiation table.
#pragma once

#include "Synth/Strike.h"

#include <array>

namespace idiophone {

/// The contact microphone's sensitivity to the velocity of the struck point, in Pa per m/s. Full
/// scale is 1 Pa, and so 1 m/s (Raghuvanshi & Lin 2006 listen to velocity).
inline constexpr double contactMicrophonePascals = 1;

/// How the object is heard: gains of the near residues (contact microphone) and the far ones
/// (radiation), and the share of the far ones, 0 to 1.
struct Listening {
    double nearGain = 1; ///< [Pa per m/s]
    double farGain = 1;
    double farShare = 0;

    bool operator==(const Listening&) const = default;
};

/// Returns the direction ℓ along which the velocity of the struck point is heard. A mode's residue
/// for the impulse J at p is (φ(p)·J)(φ(p)·ℓ). It does not depend on the sign of φ. Its sum over
/// equal poles does not depend on their basis. ℓ points inwards, so that a strike straight into the
/// surface has no negative residue.
inline std::array<float, 3> listeningDirection(const StrikePoint& point) noexcept {
    return {-point.normal[0], -point.normal[1], -point.normal[2]};
}

} // namespace idiophone
