#include "Object/Material.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <limits>
#include <numbers>

using namespace idiophone;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("A decay time is ln(1000) over half the damping, and infinite without damping") {
    Material material;
    CHECK(std::isinf(decaySeconds(material, 1000)));
    material.damping = {.fluidPerSecond = 2, .viscoelasticSeconds = 1e-8, .lossFactor = 1e-4};
    const double omega = 2 * std::numbers::pi * 1000;
    CHECK(decaySeconds(material, 1000) ==
          Approx(2 * std::log(1000) / (2 + 1e-4 * omega + 1e-8 * omega * omega)));
}

TEST_CASE("A material out of range is refused by name and figure") {
    const auto refuse = [](auto change, const char* figure) {
        Material material = materialLibrary().front();
        change(material);
        const auto result = validated(material);
        REQUIRE_FALSE(result);
        CHECK_THAT(result.error().message, ContainsSubstring("Rosewood"));
        CHECK_THAT(result.error().message, ContainsSubstring(figure));
    };
    refuse([](Material& m) { m.youngsModulusPa = 0; }, "Young's modulus");
    refuse([](Material& m) { m.densityKgPerM3 = -1; }, "density");
    refuse([](Material& m) { m.poissonRatio = 0.5; }, "Poisson");
    refuse([](Material& m) { m.damping.fluidPerSecond = std::nan(""); }, "fluid damping");
    refuse([](Material& m) { m.damping.viscoelasticSeconds = -1e-9; }, "out of range: -1e-09");
    refuse([](Material& m) { m.damping.lossFactor = -1e-9; }, "loss factor");
    refuse([](Material& m) { m.damping.lossFactor = 11; }, "loss factor");
    refuse([](Material& m) { m.restitution = std::numeric_limits<double>::infinity(); },
           "restitution");
}

TEST_CASE("A material whose texts are too long for an object's file is refused") {
    Material material = materialLibrary().front();
    material.source = std::string(40'000, 'x');
    CHECK_THAT(validated(material).error().message, ContainsSubstring("its source is longer"));
    material = materialLibrary().front();
    material.name = std::string(1001, 'x');
    CHECK_THAT(validated(material).error().message, ContainsSubstring("its name is longer"));
}
