#include "Geometry/LengthUnit.h"

#include "Geometry/ParametricMesh.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace idiophone;
using Catch::Matchers::ContainsSubstring;

namespace {
UnitGuess guessOfBox(double x, double y, double z) {
    return guessLengthUnit(boxMesh({x, y, z}, {1, 1, 1}));
}
} // namespace

TEST_CASE("A bar of 350 x 50 x 20 is taken as millimetres, and the sentence says so") {
    const auto guess = guessOfBox(350, 50, 20);
    CHECK(guess.unit.metresPerUnit == 0.001);
    CHECK(guess.isSure);
    CHECK(guess.sentence == "The mesh measures 350 x 50 x 20, which looks like millimetres.");
}

TEST_CASE("A bar of 0.35 x 0.05 x 0.02 is taken as metres") {
    const auto guess = guessOfBox(0.35, 0.05, 0.02);
    CHECK(guess.unit.metresPerUnit == 1);
    CHECK(guess.isSure);
    CHECK(guess.sentence == "The mesh measures 0.35 x 0.05 x 0.02, which looks like metres.");
}

TEST_CASE("The limit between metres and millimetres is 20 units") {
    CHECK(guessOfBox(20, 1, 1).unit.symbol == "m");
    CHECK(guessOfBox(1, 20.001, 1).unit.symbol == "mm");
    CHECK(guessOfBox(1, 1, 1234.4).sentence ==
          "The mesh measures 1 x 1 x 1234, which looks like millimetres.");
}

TEST_CASE("Sizes that fit no instrument are reported as uncertain") {
    for (const double size : {1e-5, 0.0049, 20001.0, 1e12}) {
        const auto guess = guessOfBox(size, size / 2, size / 2);
        CHECK_FALSE(guess.isSure);
        CHECK_THAT(guess.sentence, ContainsSubstring("no unit"));
        CHECK(guess.unit.symbol == (size < 1 ? "m" : "mm"));
    }
    CHECK_FALSE(guessLengthUnit({}).isSure);
}

TEST_CASE("Metres that the format states are kept, whatever the size") {
    for (const double size : {0.001, 0.1, 350.0}) {
        const auto guess = guessLengthUnit(boxMesh({size, size, size}, {1, 1, 1}), true);
        CHECK(guess.unit.symbol == "m");
        CHECK(guess.isSure == (size == 0.1));
    }
    CHECK(guessLengthUnit(boxMesh({350, 50, 20}, {1, 1, 1}), true).sentence ==
          "The mesh measures 350 x 50 x 20, which its format takes for metres, but no instrument "
          "has this size: set the unit if it is another.");
}

TEST_CASE("Units are found by symbol and by name") {
    CHECK(lengthUnitNamed("mm")->metresPerUnit == 0.001);
    CHECK(lengthUnitNamed("centimetres")->metresPerUnit == 0.01);
    CHECK(lengthUnitNamed("in")->metresPerUnit == 0.0254);
    CHECK(lengthUnitNamed("ft")->metresPerUnit == 0.3048);
    CHECK_FALSE(lengthUnitNamed("cubit"));
    CHECK_FALSE(lengthUnitNamed(""));
}

TEST_CASE("Lengths are written in millimetres without exponents") {
    CHECK(millimetresText(0.0125) == "12.5 mm");
    CHECK(millimetresText(0.00512345) == "5.12 mm");
    CHECK(millimetresText(3) == "3000 mm");
    CHECK(millimetresText(1.2344) == "1234 mm");
}
