// SPDX-License-Identifier: Apache-2.0
#include "Synth/SharedSurfaceProfile.h"

#include <algorithm>
#include <mutex>
#include <vector>

namespace idiophone {

std::shared_ptr<const SurfaceProfile> sharedSurfaceProfile(const Surface& surface,
                                                           double sampleRateHz) {
    constexpr std::size_t kept = 8; // about 1 MB each
    constexpr std::uint64_t noiseSeed = 1;
    static std::mutex mutex;
    static std::vector<std::shared_ptr<const SurfaceProfile>> profiles; // most recent last
    const std::scoped_lock lock(mutex);
    const auto known = std::ranges::find_if(profiles, [&](const auto& profile) {
        return profile->surface() == surface && profile->sampleRateHz() == sampleRateHz;
    });
    if (known != profiles.end()) {
        std::rotate(known, known + 1, profiles.end());
        return profiles.back();
    }
    auto made = std::make_shared<const SurfaceProfile>(surface, sampleRateHz, noiseSeed);
    if (profiles.size() == kept)
        profiles.erase(profiles.begin());
    profiles.push_back(made);
    return made;
}

} // namespace idiophone
