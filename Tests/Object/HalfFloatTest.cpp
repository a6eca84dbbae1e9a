#include "Object/HalfFloat.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>

using namespace idiophone;

TEST_CASE("Every half-precision number is unchanged after conversion to single and back") {
    for (std::uint32_t bits = 0; bits <= 0xffff; ++bits) {
        const auto half = static_cast<std::uint16_t>(bits);
        const float single = halfToFloat(half);
        if (std::isnan(single))
            CHECK(std::isnan(halfToFloat(floatToHalf(single))));
        else if (floatToHalf(single) != half)
            FAIL("half " << bits << " became " << floatToHalf(single));
    }
}

TEST_CASE("A single rounds to the nearest half, ties to even") {
    for (std::uint16_t half = 0; half < 0x7bff; ++half) {
        const float below = halfToFloat(half);
        const float above = halfToFloat(half + 1);
        const float middle = below + (above - below) / 2;
        const auto even = static_cast<std::uint16_t>(half % 2 == 0 ? half : half + 1);
        REQUIRE(floatToHalf(middle) == even);
        REQUIRE(floatToHalf(std::nextafter(middle, 0.0f)) == half);
        REQUIRE(floatToHalf(std::nextafter(middle, 1e9f)) == half + 1);
    }
    CHECK(floatToHalf(65504.0f) == 0x7bff);
    CHECK(floatToHalf(65520.0f) == 0x7c00);
    CHECK(floatToHalf(-1e30f) == 0xfc00);
    CHECK(halfToFloat(0x7c00) == std::numeric_limits<float>::infinity());
}
