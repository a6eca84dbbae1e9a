#include "Analysis/NoiseFloor.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace idiophone;
using Catch::Matchers::WithinRel;

TEST_CASE("The noise floor is the variance of white noise, also beside a loud tone") {
    std::mt19937 random(2);
    std::normal_distribution<double> noise(0, 0.1);
    std::vector<double> samples;
    for (int n = 0; n < 30000; ++n)
        samples.push_back(noise(random) + std::cos(2 * std::numbers::pi * 1000 * n / 48000));
    const NoiseFloor floor(samples, 48000);
    for (const double hz : {1000.0, 5000.0, 20000.0})
        CHECK_THAT(floor.energyAt(hz), WithinRel(0.01, 0.2));
    CHECK_THAT(floor.meanEnergy(), WithinRel(0.51, 0.1));
}

TEST_CASE("The noise floor of a very short recording is unknown") {
    CHECK(NoiseFloor(std::vector<double>(100, 1.0), 48000).energyAt(500) == 0);
}
