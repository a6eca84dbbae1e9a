#include "Object/Material.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

using namespace idiophone;
using Catch::Approx;

namespace {

/// One row of the published tables, with times as they are printed.
struct PublishedDecay {
    const char* name;
    double hz;
    double seconds;
    double unitOfLastDigit;
};

const Material& known(const char* name) {
    const auto* material = findMaterial(name);
    REQUIRE(material != nullptr);
    return *material;
}

} // namespace

TEST_CASE("Every library material is valid, has a name of its own and a source") {
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

TEST_CASE("Materials are found whatever the case of their name") {
    REQUIRE(findMaterial("ROSEWOOD") != nullptr);
    CHECK(findMaterial("ROSEWOOD")->name == "Rosewood");
    CHECK(findMaterial("unobtainium") == nullptr);
    CHECK(materialColour("ROSEWOOD") == 0x6b3324);
    CHECK(materialColour("Maple") == 0xcca878);
    CHECK_FALSE(materialColour("unobtainium"));
}

TEST_CASE("The choice parameter has room for the library") {
    CHECK(materialLibrary().size() <= 62); // 0 to 63, less Own and Custom
}

TEST_CASE("The first eleven materials have the figures that projects were made with") {
    struct Row {
        const char* name;
        double youngsModulusPa, densityKgPerM3, poissonRatio, gamma, eta;
    };
    for (const Row& row : {Row{"Rosewood", 12.5e9, 850, 0.25, 51.58, 2.35e-7},
                           {"Padauk", 11.7e9, 750, 0.25, 12.44, 9.16e-8},
                           {"Wood", 1.1e10, 750, 0.25, 60, 2e-6},
                           {"Ceramic", 7.2e10, 2700, 0.19, 6, 1e-7},
                           {"Glass", 6.2e10, 2600, 0.20, 1, 1e-7},
                           {"Plastic", 1.4e9, 1070, 0.35, 30, 1e-6},
                           {"Iron", 2.1e11, 8000, 0.28, 5, 1e-7},
                           {"Polycarbonate", 2.4e9, 1190, 0.37, 0.5, 4e-7},
                           {"Steel", 2.0e11, 7850, 0.29, 5, 3e-8},
                           {"Tin", 5e10, 7265, 0.325, 2, 3e-8},
                           {"Aluminium", 68.9e9, 2700, 0.33, 0.5, 1e-8}}) {
        INFO(row.name);
        const auto& material = known(row.name);
        CHECK(material.youngsModulusPa == row.youngsModulusPa);
        CHECK(material.densityKgPerM3 == row.densityKgPerM3);
        CHECK(material.poissonRatio == row.poissonRatio);
        CHECK(material.damping == DampingLaw{row.gamma, row.eta, 0});
    }
}

TEST_CASE("Decay times are those of the published tables at 440 Hz, 1 kHz and 4 kHz, to the digits "
          "printed") {
    // KleinPAT Table 4 and Chaigne & Doutaut 1997: T60 = 2 ln(1000) / (γ + η ω²).
    for (const PublishedDecay& row : {
             PublishedDecay{"Ceramic", 440, 2.04, 0.01},
             {"Ceramic", 1000, 1.39, 0.01},
             {"Ceramic", 4000, 0.200, 0.001},
             {"Glass", 440, 7.83, 0.01},
             {"Glass", 1000, 2.79, 0.01},
             {"Glass", 4000, 0.215, 0.001},
             {"Wood", 440, 0.184, 0.001},
             {"Wood", 1000, 0.099, 0.001},
             {"Wood", 4000, 0.010, 0.001},
             {"Plastic", 440, 0.367, 0.001},
             {"Plastic", 1000, 0.199, 0.001},
             {"Plastic", 4000, 0.021, 0.001},
             {"Iron", 440, 2.40, 0.01},
             {"Iron", 1000, 1.54, 0.01},
             {"Iron", 4000, 0.203, 0.001},
             {"Polycarbonate", 440, 3.88, 0.01},
             {"Polycarbonate", 1000, 0.848, 0.001},
             {"Polycarbonate", 4000, 0.055, 0.001},
             {"Steel", 440, 2.64, 0.01},
             {"Steel", 1000, 2.23, 0.01},
             {"Steel", 4000, 0.577, 0.001},
             {"Tin", 440, 6.20, 0.01},
             {"Tin", 1000, 4.34, 0.01},
             {"Tin", 4000, 0.659, 0.001},
             {"Padauk", 440, 1.05, 0.01},
             {"Padauk", 1000, 0.86, 0.01},
             {"Padauk", 4000, 0.20, 0.01},
             {"Rosewood", 440, 0.26, 0.01},
             {"Rosewood", 1000, 0.23, 0.01},
             {"Rosewood", 4000, 0.07, 0.01},
         }) {
        const double seconds = decaySeconds(known(row.name), row.hz);
        INFO(row.name << " at " << row.hz << " Hz: " << seconds << " for " << row.seconds);
        CHECK(std::abs(seconds - row.seconds) <= row.unitOfLastDigit / 2);
    }
}

TEST_CASE("Materials with a published damping ratio or loss factor have it at every frequency") {
    struct Row {
        const char* name;
        double lossFactor;
    };
    // SolidWorks' table after Cremer & Heckl gives damping ratios, half the loss factor.
    for (const Row& row : {Row{"Brass", 2 * 0.5e-3},
                           {"Copper", 2 * 1e-3},
                           {"Tin, constant Q", 2 * 1e-3},
                           {"Mild steel", 2 * 2e-4},
                           {"Bell bronze", 2e-4},
                           {"Bell glass", 2.5e-5},
                           {"Aluminium 6061", 1e-4}})
        for (const double hz : {110.0, 440.0, 4000.0}) {
            INFO(row.name << " at " << hz << " Hz");
            // T60 of a quality factor: Q ln(1000) / (π f).
            CHECK(decaySeconds(known(row.name), hz) ==
                  Approx(std::log(1000) / (3.14159265358979 * hz * row.lossFactor)));
        }
}

TEST_CASE("Every entry says where its elasticity, density, damping and contact figures come from") {
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
