// The larger of two magnitudes, for tests of sound.
#pragma once

#include <cmath>

namespace idiophone::test {

/// As std::max, but where one of them is not a number neither is this, so that no bound holds.
template <class Number>
Number larger(Number most, Number next) {
    return most >= next || std::isnan(most) ? most : next;
}

} // namespace idiophone::test
