// Tests the sound of the board under a body's clamps.
#include "Analysis/Soundboard.h"

#include "Analysis/Air.h"
#include "Analysis/Clamp.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("A force on a board of mass m is heard as rho F/(2 pi m) at all frequencies") {
    constexpr double omega = 2000, forceN = 3, boardKgPerM2 = 5;
    RadiationTable table{.directions = {{0, 0, 1}, {0, 1, 0}},
                         .frequencyRatios = {1, 2},
                         .weights = std::vector<std::complex<float>>(4)};
    addBoard(table, Eigen::VectorXd::Constant(1, omega * omega),
             Eigen::RowVectorXd::Constant(1, forceN), {0, 0.1, 0}, boardKgPerM2);
    for (std::size_t row = 0; row < table.weights.size(); ++row) {
        const std::complex<double> added(table.weights[row]);
        // The force of a modal velocity of 1 is F/ω, and in the same mode it grows with ω.
        const double ratio = table.frequencyRatios[row % 2];
        CHECK_THAT(std::abs(added), WithinRel(ratio * airDensityKgPerM3 * forceN / omega /
                                                  (2 * std::numbers::pi * boardKgPerM2),
                                              1e-5));
        // Sound from a place nearer to the listener is earlier.
        const double ahead = row < 2 ? 0 : 0.1 * ratio * omega / speedOfSoundMetresPerSecond;
        CHECK_THAT(std::arg(added) - std::numbers::pi / 2, WithinAbs(ahead, 1e-5));
    }
}

TEST_CASE("Supports without a positive resistance or board are refused in a sentence") {
    CHECK(validate(Support{}));
    CHECK(validate(Support{.resistanceNsPerM = 1, .boardKgPerM2 = 1}));
    CHECK(validate(Support{.resistanceNsPerM = 0}).error().message ==
          "The support's resistance must be a positive number of N s/m.");
    CHECK(validate(Support{.boardKgPerM2 = -1}).error().message ==
          "The board's mass must be a positive number of kg/m².");
}
