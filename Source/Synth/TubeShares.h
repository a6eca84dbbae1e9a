// What of a bar's sound comes out of its tube.
#pragma once

#include "Object/ModalObject.h"

#include <vector>

namespace idiophone {

/// [M], or empty where the object has no tube: the share of what each mode radiates that its tube
/// adds, as far as it is in phase with all of it; below 0 where the tube takes away.
///
/// The two modes that a bar's mode makes with a resonance of the tube have its shape and radiate
/// W = gain · W_bar + W_tube (Analysis/Tube.h). Their gains sum to 1, and their flows to 0, as
/// nothing flows at first: W_bar = ΣW / Σgain. A lone mode with a gain, and one of an object
/// without radiation, counts as the tube's. Any thread but audio; allocates.
std::vector<float> tubeShares(const ModalObject& object);

} // namespace idiophone
