// SPDX-License-Identifier: Apache-2.0
// The share of a bar's sound that comes out of its tube.
#pragma once

#include "Object/ModalObject.h"

#include <vector>

namespace idiophone {

/// Returns [M], or empty if the object has no tube: the tube's share of each mode's radiation, as
/// far as it is in phase with the whole. It is negative if the tube reduces the sound.
///
/// A bar's mode and a resonance of the tube make two modes with the shape of the bar's mode. They
/// radiate W = gain · W_bar + W_tube (Analysis/Tube.h). Their gains sum to 1, and their flows to 0,
/// because nothing flows at first: W_bar = ΣW / Σgain. A single mode with a gain counts as the
/// tube's, and so do all such modes of an object without radiation. Any thread except the audio
/// thread; allocates.
std::vector<float> tubeShares(const ModalObject& object);

} // namespace idiophone
