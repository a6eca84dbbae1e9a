#include "Instrument/Motor.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <vector>

using namespace idiophone;
using Catch::Matchers::WithinAbs;

TEST_CASE("The discs open and close twice a turn, to the given depth") {
    constexpr double cellSeconds = 1.0 / 1000;
    Motor motor(cellSeconds);
    std::vector<float> gains;
    for (int k = 0; k < 3000; ++k)
        gains.push_back(motor.advance(2.5, 0.6));
    const auto [least, greatest] = std::minmax_element(gains.begin() + 1000, gains.end());
    CHECK_THAT(*least, WithinAbs(0.4, 1e-3));
    CHECK_THAT(*greatest, WithinAbs(1, 1e-3));
    int openings = 0;
    for (std::size_t k = 1001; k + 1 < gains.size(); ++k)
        openings += gains[k] > gains[k - 1] && gains[k] >= gains[k + 1] ? 1 : 0;
    CHECK(openings == 9); // five a second, between the first second and the third
}

TEST_CASE("Without depth the gain is one, and a reset restarts the motor") {
    Motor motor(0.001);
    for (int k = 0; k < 100; ++k)
        CHECK(motor.advance(12, 0) == 1);
    Motor fresh(0.001);
    motor.reset();
    for (int k = 0; k < 1000; ++k)
        CHECK(motor.advance(3, 1) == fresh.advance(3, 1));
}

TEST_CASE("A motor jumps to a given phase, or moves there smoothly by the shorter way") {
    constexpr double cellSeconds = 64.0 / 48000, turnsPerSecond = 1;
    const auto there = [](double turns) { // a motor long after its start
        Motor motor(cellSeconds);
        for (int k = 0; k < 1000; ++k)
            motor.advance(0, 1);
        motor.keepTo(turns, true);
        return motor;
    };
    CHECK(there(17.25).advance(turnsPerSecond, 1) == there(0.25).advance(turnsPerSecond, 1));
    CHECK(there(-0.75).advance(turnsPerSecond, 1) == there(0.25).advance(turnsPerSecond, 1));

    for (const double behind : {0.2, -0.2, 0.45, 7.3}) {
        CAPTURE(behind);
        auto late = there(0), right = there(0);
        float before = late.advance(turnsPerSecond, 1);
        right.advance(turnsPerSecond, 1);
        for (int k = 1; k < 1000; ++k) {
            const double turns = behind + turnsPerSecond * cellSeconds * k;
            late.keepTo(turns, false);
            right.keepTo(turns, true);
            const float gain = late.advance(turnsPerSecond, 1);
            CHECK(std::abs(gain - before) < 0.04f);
            const float wanted = right.advance(turnsPerSecond, 1);
            if (k > 900)
                CHECK_THAT(gain, WithinAbs(wanted, 1e-3));
            before = gain;
        }
    }
}

TEST_CASE(
    "A motor that starts, stops or changes its depth never steps by more than a fifth in a cell") {
    Motor motor(64.0 / 48000);
    float before = 1;
    for (int k = 0; k < 4000; ++k) {
        const float gain = motor.advance(k / 500 % 2 == 0 ? 12 : 0, k / 300 % 2 == 0 ? 1 : 0);
        CHECK(std::abs(gain - before) < 0.2f);
        before = gain;
    }
}
