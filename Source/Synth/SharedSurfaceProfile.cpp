// SPDX-License-Identifier: Apache-2.0
#include "Synth/SharedSurfaceProfile.h"

#include "Synth/RecentProfiles.h"

#include <mutex>

namespace idiophone {

std::shared_ptr<const SurfaceProfile> sharedSurfaceProfile(const Surface& surface,
                                                           double sampleRateHz) {
    static std::mutex mutex;
    static RecentProfiles profiles;
    const std::scoped_lock lock(mutex);
    return profiles.profile(surface, sampleRateHz);
}

} // namespace idiophone
