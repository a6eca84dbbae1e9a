#include "Object/Material.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <limits>

using namespace idiophone;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("Every library material is valid, has a name of its own and a source") {
    for (const auto& material : materialLibrary()) {
        INFO(material.name);
        CHECK(validated(material));
        CHECK_FALSE(material.source.empty());
        CHECK(findMaterial(material.name) == &material);
    }
}

TEST_CASE("Materials are found whatever the case of their name") {
    REQUIRE(findMaterial("ROSEWOOD") != nullptr);
    CHECK(findMaterial("ROSEWOOD")->name == "Rosewood");
    CHECK(findMaterial("unobtainium") == nullptr);
}

TEST_CASE("Decay times agree with the published table at 440 Hz, 1 kHz and 4 kHz") {
    // KleinPAT Table 4 and Chaigne & Doutaut 1997: T60 = 2 ln(1000) / (γ + η ω²).
    const auto check = [](const char* name, double at440, double at1000, double at4000) {
        INFO(name);
        const auto* material = findMaterial(name);
        REQUIRE(material != nullptr);
        CHECK(decaySeconds(*material, 440) == Approx(at440).epsilon(0.025));
        CHECK(decaySeconds(*material, 1000) == Approx(at1000).epsilon(0.025));
        CHECK(decaySeconds(*material, 4000) == Approx(at4000).epsilon(0.06));
    };
    check("Ceramic", 2.04, 1.39, 0.200);
    check("Glass", 7.83, 2.79, 0.215);
    check("Wood", 0.184, 0.099, 0.010);
    check("Plastic", 0.367, 0.199, 0.021);
    check("Iron", 2.40, 1.54, 0.203);
    check("Polycarbonate", 3.88, 0.848, 0.055);
    check("Steel", 2.64, 2.23, 0.577);
    check("Tin", 6.20, 4.34, 0.659);
    check("Padauk", 1.05, 0.86, 0.20);
    check("Rosewood", 0.26, 0.23, 0.07);
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
    refuse([](Material& m) { m.fluidDampingPerSecond = std::nan(""); }, "fluid damping");
    refuse([](Material& m) { m.viscoelasticDampingSeconds = -1e-9; }, "visco-elastic");
    refuse([](Material& m) { m.restitution = std::numeric_limits<double>::infinity(); },
           "restitution");
}
