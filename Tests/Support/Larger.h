// Returns the larger of two magnitudes, for tests of sound.
#pragma once

#include <cmath>

namespace idiophone::test {

/// Like std::max, but returns NaN if either argument is NaN, so that no bound holds.
template <class Number>
Number larger(Number most, Number next) {
    return most >= next || std::isnan(most) ? most : next;
}

} // namespace idiophone::test
