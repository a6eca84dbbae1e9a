#include "Object/RadiationTable.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

using namespace idiophone;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Returns a table of two directions, three ratios and two modes.
RadiationTable table() {
    return {.directions = {{0, 0, 1}, {0.6f, -0.8f, 0}},
            .frequencyRatios = {0.5, 1, 4},
            .weights = {1, 2, 3, 4, 5, 6, -1, {0, -2}, -3, {0, -4}, 5, 60}};
}

using Weights = std::vector<std::complex<float>>;

Weights at(std::size_t direction, double ratio) {
    Weights weights(2);
    table().weightsAt(direction, ratio, weights);
    return weights;
}

} // namespace

TEST_CASE("At a tabulated ratio the weights are the tabulated ones") {
    CHECK(at(0, 0.5) == Weights{1, 2});
    CHECK(at(0, 1) == Weights{3, 4});
    CHECK(at(0, 4) == Weights{5, 6});
    CHECK(at(1, 1) == Weights{-3, {0, -4}});
}

TEST_CASE("Between tabulated ratios magnitudes are linear in the logarithm of the ratio") {
    CHECK_THAT(std::abs(at(0, 2)[0]), WithinRel(4.0f, 1e-6f));
    CHECK_THAT(std::abs(at(0, std::sqrt(0.5))[1]), WithinRel(3.0f, 1e-6f));
}

TEST_CASE("Between tabulated ratios the phase takes the shorter way and no weight vanishes") {
    const auto between = at(1, 2)[1]; // from −4i to 60
    CHECK_THAT(std::abs(between), WithinRel(32.0f, 1e-6f));
    CHECK_THAT(std::arg(between), WithinRel(-std::numbers::pi_v<float> / 4, 1e-6f));
    for (const double ratio : {1.1, 1.9, 2.0, 2.1, 3.9}) { // from −3 to 5
        CHECK_THAT(std::abs(at(1, ratio)[0]),
                   WithinRel(3 + static_cast<float>(std::log(ratio) / std::log(4)) * 2, 1e-5f));
    }
}

TEST_CASE("Below the table weights fall with the square of the ratio") {
    CHECK(at(1, 0.25) == Weights{-0.25f, {0, -0.5f}});
    for (const double ratio : {0.0, -1.0, -infinity, notANumber})
        CHECK(at(1, ratio) == Weights{-1, {0, -2}});
}

TEST_CASE("Above the table the weights are constant") {
    for (const double ratio : {4.5, 1e300, infinity})
        CHECK(at(1, ratio) == Weights{5, 60});
}

TEST_CASE("A table of one ratio gives its weights at every higher ratio") {
    const RadiationTable one{
        .directions = {{1, 0, 0}}, .frequencyRatios = {1}, .weights = {7, 8, 9}};
    CHECK(faultOf(one, 3).empty());
    for (const double ratio : {1.0, 10.0}) {
        Weights weights(3);
        one.weightsAt(0, ratio, weights);
        CHECK(weights == one.weights);
    }
}

TEST_CASE("Each malformed part of a radiation table is named") {
    CHECK(faultOf({}, 2).empty());
    CHECK(faultOf(table(), 2).empty());
    const auto refuse = [](auto change, const char* sentence) {
        auto changed = table();
        change(changed);
        CHECK_THAT(faultOf(changed, 2), ContainsSubstring(sentence));
    };
    const char* const size = "directions x ratios x modes";
    refuse([](auto& t) { t.directions.clear(); }, size);
    refuse([](auto& t) { t.frequencyRatios.clear(); }, size);
    refuse([](auto& t) { t.weights.clear(); }, size);
    refuse([](auto& t) { t.weights.pop_back(); }, size);
    refuse([](auto& t) { t.weights.resize(24); }, size);
    refuse([](auto& t) { t.directions.pop_back(); }, size);
    refuse([](auto& t) { t.directions[1] = {0.6f, 0.8f, 0.1f}; }, "unit vector");
    refuse([](auto& t) { t.directions[0] = {0, 0, 0}; }, "unit vector");
    refuse([](auto& t) { t.directions[0][1] = static_cast<float>(notANumber); }, "unit vector");
    refuse([](auto& t) { t.directions[0][1] = static_cast<float>(infinity); }, "unit vector");
    refuse([](auto& t) { t.frequencyRatios[0] = 0; }, "between 1e-6 and 1e6");
    refuse([](auto& t) { t.frequencyRatios[0] = 5e-324; }, "between 1e-6 and 1e6");
    refuse([](auto& t) { t.frequencyRatios[1] = notANumber; }, "between 1e-6 and 1e6");
    refuse([](auto& t) { t.frequencyRatios[2] = infinity; }, "between 1e-6 and 1e6");
    refuse([](auto& t) { t.frequencyRatios[1] = 0.5; }, "ascending order");
    refuse([](auto& t) { std::swap(t.frequencyRatios[1], t.frequencyRatios[2]); },
           "ascending order");
    refuse([](auto& t) { t.weights[7] = static_cast<float>(notANumber); }, "weight");
    refuse([](auto& t) { t.weights[7] = static_cast<float>(-infinity); }, "weight");
    CHECK_THAT(faultOf(table(), 3), ContainsSubstring("directions x ratios"));
    CHECK_THAT(faultOf(table(), 0), ContainsSubstring("directions x ratios"));
}

TEST_CASE("Reading weights from one mode onwards gives the same values as reading all") {
    for (const double ratio : {0.3, 0.7, 1.0, 2.0, 9.0}) {
        Weights one(1);
        table().weightsAt(1, ratio, one, 1);
        CHECK(one[0] == at(1, ratio)[1]);
    }
}

TEST_CASE("A table with more than two directions returns the one nearest to a listener") {
    RadiationTable table;
    table.directions = {{1, 0, 0}, {0, 1, 0}};
    CHECK_FALSE(table.directionTowards({0, 0, 1}));
    table.directions.push_back({0, 0, 1});
    table.directions.push_back({0, 0, -1});
    CHECK(table.directionTowards({0.3f, -0.2f, 0.4f}) == 2u);
    CHECK(table.directionTowards({3, 2, -2}) == 0u);
    CHECK(table.directionTowards({0, -1, -2}) == 3u);
}
