// Repeatable random numbers. Variations of a strike depend on its number only, so that a render
// repeats.
#pragma once

#include <cstdint>

namespace idiophone {

/// Returns −1 to 1, evenly distributed, from an integer (the finaliser of MurmurHash3).
inline double scatter(std::uint32_t number) {
    number ^= number >> 16;
    number *= 0x85ebca6bu;
    number ^= number >> 13;
    number *= 0xc2b2ae35u;
    number ^= number >> 16;
    return number / 2147483647.5 - 1;
}

} // namespace idiophone
