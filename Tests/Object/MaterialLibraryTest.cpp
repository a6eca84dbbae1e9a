#include "Object/Material.h"
#include "Object/MaterialKind.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

using namespace idiophone;
using Catch::Approx;

namespace {

const Material& known(const char* name) {
    const auto* material = findMaterial(name);
    REQUIRE(material != nullptr);
    return *material;
}

} // namespace

TEST_CASE("Every library material is valid and has a unique name and a source") {
    std::set<std::string> names;
    for (const auto& material : materialLibrary()) {
        INFO(material.name);
        CHECK(validated(material));
        CHECK_FALSE(material.source.empty());
        CHECK(findMaterial(material.name) == &material);
        CHECK(names.insert(material.name).second);
        CHECK(std::isfinite(decaySeconds(material, 1000)));
    }
}

TEST_CASE("Material names are found in upper and lower case") {
    REQUIRE(findMaterial("ROSEWOOD") != nullptr);
    CHECK(findMaterial("ROSEWOOD")->name == "Rosewood");
    CHECK(findMaterial("unobtainium") == nullptr);
    CHECK(materialColour("ROSEWOOD") == 0x6b3324);
    CHECK(materialColour("Maple") == 0xcca878);
    CHECK_FALSE(materialColour("unobtainium"));
    CHECK(materialKind("PADAUK") == MaterialKind::wood);
    CHECK(materialKind("Tin") == MaterialKind::metal);
    CHECK_FALSE(materialKind("unobtainium"));
}

TEST_CASE("The choice parameter has enough values for the library") {
    CHECK(materialLibrary().size() <= 62); // 0 to 63, without Own and Custom
}

TEST_CASE("The damping of materials equals the published measurements") {
    struct Row {
        const char* name;
        DampingLaw law; ///< γ, η, χ
    };
    for (const Row& row :
         {// H. Hill 2012: the mean over a marimba's bars.
          Row{"Rosewood", {0, 0, 0.45e-2}},
          // Chaigne & Lambourg 2001: a spruce plate with Q = 80. KleinPAT Table 4: the fluid term.
          {"Wood", {60, 0, 1.0 / 80}},
          // Medians of RealImpact's ceramic bowl, glass cup and iron skillet.
          {"Ceramic", {0, 0, 1.2e-3}},
          {"Glass", {0, 0, 1.3e-3}},
          {"Iron", {0, 0, 1.1e-3}},
          // Cremer & Heckl: flexural loss factors. Brass: the geometric mean of 0.2e-3 and 1e-3.
          {"Aluminium", {0, 0, 1e-4}},
          {"Copper", {0, 0, 2e-3}},
          {"Tin", {0, 0, 2e-3}},
          {"Brass", {0, 0, 4.5e-4}},
          {"Mild steel", {0, 0, 2e-4}},
          // KleinPAT Table 4: the fluid term.
          {"Steel", {5, 0, 6e-4}},
          {"Polycarbonate", {0.5, 4e-7, 0}},
          {"Bell bronze", {0, 0, 2e-4}},
          {"Bell glass", {0, 0, 2.5e-5}},
          // Birch & Bancroft 1938: Q = 150.
          {"Granite", {0, 0, 6.7e-3}}}) {
        INFO(row.name);
        CHECK(known(row.name).damping == row.law);
    }
}

TEST_CASE("A loss factor gives the same quality factor at every frequency") {
    const auto& rosewood = known("Rosewood");
    for (const double hz : {65.4, 523.25, 2093.0, 8000.0}) {
        INFO(hz << " Hz");
        // T60 = ln(1000) Q/(π f) = 2.2/(χ f).
        CHECK(decaySeconds(rosewood, hz) == Approx(2.1988 / (0.0045 * hz)).epsilon(1e-4));
    }
}

TEST_CASE("Padauk has the damping of Chaigne and Doutaut's padauk bar at 440 Hz") {
    const DampingLaw published{.fluidPerSecond = 12.44, .viscoelasticSeconds = 9.16e-8};
    const double eigenvalue = std::pow(2 * 3.14159265358979 * 440, 2);
    CHECK(known("Padauk").damping.perSecond(eigenvalue) ==
          Approx(published.perSecond(eigenvalue)).epsilon(0.02));
}

TEST_CASE("Rosewood has the elasticity and density of one measured bar") {
    const auto& rosewood = known("Rosewood");
    CHECK(rosewood.youngsModulusPa == 23.9e9);
    CHECK(rosewood.densityKgPerM3 == 1082);
    REQUIRE(rosewood.grain);
    CHECK(rosewood.grain->shearModulusLR * rosewood.youngsModulusPa == Approx(4.0e9).epsilon(0.01));
    CHECK(rosewood.grain->shearModulusLT == rosewood.grain->shearModulusLR);
}

TEST_CASE("Every material names its sources of elasticity, density, damping and contact") {
    std::ifstream file(IDIOPHONE_SOURCE_DIR "/Resources/Materials/materials.json");
    const auto root = nlohmann::json::parse(file);
    CHECK(root["materials"].size() == materialLibrary().size());
    for (const auto& entry : root["materials"]) {
        INFO(entry["name"]);
        for (const char* part : {"elasticity", "density", "damping", "contact"}) {
            REQUIRE(entry["source"].contains(part));
            CHECK(entry["source"][part].get<std::string>().size() >= 8);
            const auto* material = findMaterial(entry["name"].get<std::string>());
            REQUIRE(material != nullptr);
            CHECK(material->source.find(entry["source"][part].get<std::string>()) !=
                  std::string::npos);
        }
        for (const char* figure : {"friction", "restitution", "roughness"})
            CHECK(entry.contains(figure));
    }
}
