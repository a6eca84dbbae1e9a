#include "Object/NumberText.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>

using namespace idiophone;

TEST_CASE("A word that is only partly a number is refused") {
    CHECK(parseNumber("-1.5e3") == -1500);
    CHECK(parseNumber("+2") == 2);
    CHECK(parseNumber("inf") == std::numeric_limits<double>::infinity());
    CHECK(parseNumber("-Infinity") == -std::numeric_limits<double>::infinity());
    REQUIRE(parseNumber("nan"));
    CHECK(std::isnan(*parseNumber("nan")));
    for (const char* word : {"", "+", "-", "1,5", "1.5x", "0x10", " 1", "++1", "1e999"}) {
        INFO(word);
        CHECK_FALSE(parseNumber(word));
    }
}

TEST_CASE("A number is written with its significant digits and a decimal point") {
    CHECK(numberText(0.25) == "0.25");
    CHECK(numberText(-1e-9) == "-1e-09");
    CHECK(numberText(1234.5678, 3) == "1.23e+03");
    CHECK(numberText(3) == "3");
    CHECK(numberText(std::nan("")) == "nan");
    CHECK(numberText(std::numeric_limits<double>::infinity()) == "inf");
}
