#include "Instrument/Lfo.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

using namespace idiophone;
using Catch::Approx;

TEST_CASE("Each shape of an LFO has its values over a swing, also before the song begins") {
    using enum LfoShape;
    const std::vector<std::pair<LfoShape, std::vector<double>>> atEighths{
        {sine, {0, std::sqrt(0.5), 1, std::sqrt(0.5), 0, -std::sqrt(0.5), -1, -std::sqrt(0.5)}},
        {triangle, {0, 0.5, 1, 0.5, 0, -0.5, -1, -0.5}},
        {square, {1, 1, 1, 1, -1, -1, -1, -1}},
        {rising, {-1, -0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75}},
        {falling, {1, 0.75, 0.5, 0.25, 0, -0.25, -0.5, -0.75}}};
    for (const auto& [shape, values] : atEighths)
        for (std::size_t i = 0; i < values.size(); ++i)
            for (const double whole : {-2.0, 0.0, 7.0}) {
                INFO(static_cast<int>(shape) << ", " << i << "/8");
                CHECK(lfoValue(shape, whole + static_cast<double>(i) / 8, 1) ==
                      Approx(values[i]).margin(1e-9));
            }
}

TEST_CASE("The random shape holds another value in each swing, and repeats with its seed") {
    std::set<double> values;
    for (int swing = -20; swing < 20; ++swing) {
        const double value = lfoValue(LfoShape::random, swing, 1);
        CHECK(std::abs(value) <= 1);
        CHECK(values.insert(value).second);
        CHECK(lfoValue(LfoShape::random, swing + 0.99, 1) == value);
        CHECK(lfoValue(LfoShape::random, swing, 2) != value);
    }
    CHECK(*values.begin() < -0.8);
    CHECK(*values.rbegin() > 0.8);
}

TEST_CASE("An LFO swings at its rate, in the tempo, or where the song stands") {
    Lfo lfo(0.01);
    for (int cell = 0; cell < 100; ++cell)
        lfo.beginCell(2, 0, 120, 55.0);
    CHECK(lfo.swings() == Approx(1.98));
    const double before = lfo.swings();
    for (int cell = 0; cell < 100; ++cell)
        lfo.beginCell(2, 4, 120, std::nullopt); // 4 beats take 2 s
    CHECK(lfo.swings() - before == Approx(0.02 + 0.99 * 0.5));
    lfo.beginCell(2, 4, 120, 6.0);
    CHECK(lfo.swings() == 1.5);
    lfo.beginCell(2, 4, 0, std::nullopt); // the song has stopped
    CHECK(lfo.swings() == Approx(1.505));
    lfo.beginCell(2, 4, 0, std::nullopt); // without a tempo: its own rate
    CHECK(lfo.swings() == Approx(1.525));
    lfo.reset();
    lfo.beginCell(2, 0, 0, std::nullopt);
    CHECK(lfo.swings() == 0);
}
