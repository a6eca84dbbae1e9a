// SPDX-License-Identifier: Apache-2.0
// Keeps the surface profiles that were used last.
#pragma once

#include "Synth/SurfaceProfile.h"

#include <memory>
#include <vector>

namespace idiophone {

/// Not thread-safe.
class RecentProfiles {
public:
    /// Returns the profile of a valid surface at this rate, a kept one or a new one. Allocates.
    std::shared_ptr<const SurfaceProfile> profile(const Surface& surface, double sampleRateHz);

private:
    std::vector<std::shared_ptr<const SurfaceProfile>> kept; ///< most recent last
};

} // namespace idiophone
