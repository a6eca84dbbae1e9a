// SPDX-License-Identifier: Apache-2.0
#include "Synth/RecentProfiles.h"

#include <algorithm>

namespace idiophone {

std::shared_ptr<const SurfaceProfile> RecentProfiles::profile(const Surface& surface,
                                                              double sampleRateHz) {
    constexpr std::size_t maximumKept = 8; // about 1 MB each
    constexpr std::uint64_t noiseSeed = 1;
    const auto known = std::ranges::find_if(kept, [&](const auto& profile) {
        return profile->surface() == surface && profile->sampleRateHz() == sampleRateHz;
    });
    if (known != kept.end()) {
        std::rotate(known, known + 1, kept.end());
        return kept.back();
    }
    auto made = std::make_shared<const SurfaceProfile>(surface, sampleRateHz, noiseSeed);
    if (kept.size() == maximumKept)
        kept.erase(kept.begin());
    kept.push_back(made);
    return made;
}

} // namespace idiophone
