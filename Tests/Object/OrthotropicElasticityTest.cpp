#include "Object/OrthotropicElasticity.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <limits>

using namespace idiophone;

TEST_CASE("Isotropic constants are valid exactly for -1 < nu < 0.5") {
    for (const double nu : {-0.99, -0.3, 0.0, 0.3, 0.499})
        CHECK(validated(isotropicElasticity(20e9, nu)));
    for (const double nu : {-1.01, 0.501, 0.9})
        CHECK_FALSE(validated(isotropicElasticity(20e9, nu)));
}

TEST_CASE("A modulus that is zero, negative or not finite is refused by name") {
    const double bad = GENERATE(0.0, -1e9, std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::quiet_NaN());
    auto elasticity = isotropicElasticity(20e9, 0.3);
    elasticity.shearModulusRTPa = bad;
    const auto result = validated(elasticity);
    REQUIRE_FALSE(result);
    CHECK(result.error().message.find("shear modulus RT") != std::string::npos);
}

TEST_CASE("A Poisson ratio above the root of the ratio of the moduli is refused by name") {
    auto elasticity = isotropicElasticity(16e9, 0.1);
    elasticity.youngsModulusTPa = 1e9;
    elasticity.poissonRatioLT = 3.9; // √(16/1) = 4
    elasticity.poissonRatioRT = elasticity.poissonRatioLR = 0;
    CHECK(validated(elasticity));
    elasticity.poissonRatioLT = 4.1;
    const auto result = validated(elasticity);
    REQUIRE_FALSE(result);
    CHECK(result.error().message.find("LT") != std::string::npos);
}

TEST_CASE("Poisson's ratios that are valid one by one but not together are refused") {
    auto elasticity = isotropicElasticity(10e9, 0);
    elasticity.poissonRatioLR = elasticity.poissonRatioRT = elasticity.poissonRatioLT = 0.6;
    CHECK_FALSE(validated(elasticity));
    elasticity.poissonRatioLT = -0.6; // now the determinant is positive
    CHECK_FALSE(validated(isotropicElasticity(10e9, 0.6)));
    elasticity.poissonRatioLR = elasticity.poissonRatioRT = 0.5;
    elasticity.poissonRatioLT = 0.4;
    CHECK(validated(elasticity));
}
