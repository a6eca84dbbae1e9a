// Surface profiles shared by every player of this process. What a profile is stands in
// Synth/SurfaceProfile.h.
#pragma once

#include "Synth/SurfaceProfile.h"

#include <memory>

namespace idiophone {

/// The profile of a valid surface at this rate; making one takes some 50 ms, and the few used last
/// are kept. The same surface and rate give the same profile. Thread-safe; it locks and allocates,
/// so never on the audio thread.
std::shared_ptr<const SurfaceProfile> sharedSurfaceProfile(const Surface& surface,
                                                           double sampleRateHz);

} // namespace idiophone
