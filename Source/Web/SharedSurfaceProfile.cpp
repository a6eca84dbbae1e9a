// SPDX-License-Identifier: Apache-2.0
#include "Synth/SharedSurfaceProfile.h"

#include "Synth/RecentProfiles.h"

std::shared_ptr<const idiophone::SurfaceProfile>
idiophone::sharedSurfaceProfile(const Surface& surface, double sampleRateHz) {
    static RecentProfiles profiles; // there is one thread
    return profiles.profile(surface, sampleRateHz);
}
