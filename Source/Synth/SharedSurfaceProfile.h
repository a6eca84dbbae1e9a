// SPDX-License-Identifier: Apache-2.0
// Surface profiles shared by every player of this process (Synth/SurfaceProfile.h).
#pragma once

#include "Synth/SurfaceProfile.h"

#include <memory>

namespace idiophone {

/// Returns the profile of a valid surface at this rate. Making one takes about 50 ms; the most
/// recent ones are kept. The same surface and rate give the same profile. Thread-safe; it locks and
/// allocates, so never on the audio thread.
std::shared_ptr<const SurfaceProfile> sharedSurfaceProfile(const Surface& surface,
                                                           double sampleRateHz);

} // namespace idiophone
