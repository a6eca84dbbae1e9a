#include "Sampling/ObjectPlaces.h"

#include "Support/SyntheticObject.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

TEST_CASE("Places spread over an object, and fewer are the first ones of more") {
    auto object = test::syntheticObject({440});
    object.mass.centreMetres = {0.4, 0.4, 0};
    const auto four = spreadPlaces(object, 4);
    REQUIRE(four);
    CHECK(*four == std::vector<std::size_t>{2, 0, 1, 3}); // the far corner, then its opposite
    CHECK(*spreadPlaces(object, 2) == std::vector<std::size_t>{2, 0});
    CHECK(vertexOfRow(object, 2) == std::array<double, 3>{1, 1, 0});
}

TEST_CASE("More places than an object has are refused") {
    const auto five = spreadPlaces(test::syntheticObject({440}), 5);
    REQUIRE(!five);
    CHECK(five.error().message == "it has mode shapes at only 4 places");
}
