#include "Instrument/LowestModes.h"
#include "Support/SyntheticObject.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

TEST_CASE("Each pair counts once among the lowest eight frequencies, which follow a ratio") {
    const LowestModes modes(
        syntheticObject({50, 50.1, 135, 135.5, 260, 430, 650, 900, 1200, 1550, 1950}));
    REQUIRE(modes.count == 8);
    const double expected[] = {50, 135, 260, 430, 650, 900, 1200, 1550};
    for (std::size_t k = 0; k < 8; ++k)
        CHECK(modes.span()[k] == Approx(expected[k]));
    CHECK(modes.moved(1.5).span()[1] == Approx(202.5));
    CHECK(modes.moved(0.1).span()[0] == 20);
    CHECK(LowestModes(syntheticObject({100, 300})).span().size() == 2);
}

TEST_CASE("Lowest modes follow a live thickness, each by its share of bending") {
    auto shell = syntheticObject({100, 300, 900});
    const LowestModes solid(shell);
    shell.bending = {0, shell.eigenvalues[1], shell.eigenvalues[2] / 2};
    const LowestModes own(shell);
    CHECK(own.atThickness(1).frequenciesHz == own.frequenciesHz);
    CHECK(solid.atThickness(3).frequenciesHz == solid.frequenciesHz);
    for (const double ratio : {0.25, 2.0, 4.0}) {
        const auto moved = own.atThickness(ratio);
        for (std::size_t mode = 0; mode < 3; ++mode)
            CHECK(moved.span()[mode] ==
                  Approx(std::sqrt(shell.eigenvalueAt(mode, ratio)) / (2 * std::numbers::pi)));
    }
}
