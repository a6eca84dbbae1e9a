// Values that are known for some keys, and between them.
#pragma once

#include <iterator>
#include <map>

namespace idiophone {

/// Interpolates between the known keys; beyond them takes the nearest. At least one must be known.
inline double valueBetweenKeys(const std::map<int, double>& known, int note) {
    const auto above = known.lower_bound(note);
    if (above == known.begin())
        return above->second;
    if (above == known.end())
        return known.rbegin()->second;
    const auto below = std::prev(above);
    const double share =
        static_cast<double>(note - below->first) / static_cast<double>(above->first - below->first);
    return below->second + share * (above->second - below->second);
}

} // namespace idiophone
