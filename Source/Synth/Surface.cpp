// SPDX-License-Identifier: Apache-2.0
#include "Synth/Surface.h"

#include <algorithm>

namespace idiophone {
namespace {

struct Range {
    const char* what;
    double Surface::*member;
    double lowest, highest;
    const char* range;
};

constexpr Range ranges[] = {
    {"spectrum exponent", &Surface::spectrumExponent, -4, 1, "-4 to 1"},
    {"reson frequency", &Surface::resonFrequencyHz, 10, 20000, "10 to 20000 Hz"},
    {"reson damping", &Surface::resonDampingPerSecond, 1, 1e5, "1 to 100000 per second"},
    {"reference speed", &Surface::referenceSpeedMetresPerSecond, 0.001, 100, "0.001 to 100 m/s"},
    {"roughness", &Surface::roughness, 0, 100, "0 to 100"},
};

} // namespace

Surface heldToRanges(Surface surface) {
    for (const auto& range : ranges)
        surface.*range.member = std::clamp(surface.*range.member, range.lowest, range.highest);
    return surface;
}

Result<Surface> validated(Surface surface) {
    if (surface.name.size() > Surface::longestNameBytes)
        return failure("the surface's name is longer than " +
                       std::to_string(Surface::longestNameBytes) + " bytes");
    for (const auto& [what, member, lowest, highest, range] : ranges)
        if (!(surface.*member >= lowest && surface.*member <= highest))
            return failure("the surface's " + std::string(what) + " is not " + range);
    if (!(surface.slowestSpeedMetresPerSecond >= 0 &&
          surface.slowestSpeedMetresPerSecond <= surface.referenceSpeedMetresPerSecond))
        return failure("the surface's slowest speed is not 0 to its reference speed");
    return surface;
}

} // namespace idiophone
