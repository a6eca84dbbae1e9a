#include "Object/MaterialFile.h"
#include "Support/TestFolder.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cstdlib>
#include <fstream>
#include <random>

using namespace idiophone;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;

namespace {

const std::string good = R"({
    "name": "Jade",
    "youngs_modulus_pa": 1.1e11,
    "density_kg_per_m3": 3300,
    "poisson_ratio": 0.27,
    "fluid_damping_per_s": 3,
    "viscoelastic_damping_s": 2e-8,
    "loss_factor": 1e-4,
    "friction": 0.4,
    "restitution": 0.7,
    "roughness": 0.1,
    "source": {"elasticity": "a guess", "damping": "another"}
})";

std::string with(const std::string& before, const std::string& after) {
    auto text = good;
    const auto place = text.find(before);
    REQUIRE(place != std::string::npos);
    return text.replace(place, before.size(), after);
}

/// Returns an empty folder for this test.
std::filesystem::path folder(const char* name) {
    const auto path = test::testFolder() / name;
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
    return path;
}

void write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

} // namespace

TEST_CASE("A material file sets every figure, and its sources become one text") {
    const auto jade = parseMaterial(good, "jade.json");
    REQUIRE(jade);
    CHECK(
        *jade ==
        Material{.name = "Jade",
                 .youngsModulusPa = 1.1e11,
                 .densityKgPerM3 = 3300,
                 .poissonRatio = 0.27,
                 .damping = {.fluidPerSecond = 3, .viscoelasticSeconds = 2e-8, .lossFactor = 1e-4},
                 .friction = 0.4,
                 .restitution = 0.7,
                 .roughness = 0.1,
                 .source = "elasticity: a guess; damping: another"});
}

TEST_CASE("Every material is read back as it was written, to the last bit") {
    for (const auto& material : materialLibrary()) {
        const auto back = parseMaterial(encodeMaterial(material), "back.json");
        REQUIRE(back);
        CHECK(*back == material);
    }
}

TEST_CASE(
    "A material needs elasticity, density and one law of damping, and takes its file's name") {
    const auto plain = parseMaterial(
        R"({"youngs_modulus_pa": 1e10, "density_kg_per_m3": 800, "poisson_ratio": 0.3,
            "loss_factor": 0.01, "t60_s": {"440": 0.5}})",
        "folder/Balsa.json");
    REQUIRE(plain);
    CHECK(plain->name == "Balsa");
    CHECK(plain->damping == DampingLaw{.lossFactor = 0.01});
}

TEST_CASE("An invalid material is refused in one sentence that names the file and the fault") {
    const std::string deep(100000, '[');
    for (const auto& [text, fault] :
         {std::pair<std::string, const char*>{"", "not JSON"},
          {"{", "not JSON"},
          {deep, "not JSON"},
          {"[]", "not a JSON object"},
          {"null", "not a JSON object"},
          {R"({"name": "Empty"})", "lacks 'youngs_modulus_pa'"},
          {with("\"name\"", "\"nam\\ne\""), "no 'nam?e'"},
          {with("\"Jade\"", "7"), "'name' is not a text"},
          {with("\"Jade\"", "\"\""), "name is empty"},
          {with("\"Jade\"", "\"a\\nb\""), "control characters"},
          {with("Jade", std::string(101, 'x')), "longer than 100"},
          {with("1.1e11", "\"stiff\""), "'youngs_modulus_pa' is not a number"},
          {with("1.1e11", "null"), "'youngs_modulus_pa' is not a number"},
          {with("1.1e11", "1e999"), "not JSON"},
          {with("3300", "-1"), "density"},
          {with("0.27", "0.5"), "Poisson"},
          {with("1e-4", "-1e-4"), "loss factor"},
          {with("\"a guess\"", "1"), "'elasticity' that is not a text"},
          {with("\"elasticity\"", "\"colour\""), "no 'colour'"},
          {with("\"name\"", "\"kind\""), "'kind' is none of wood"},
          {with(R"({"elasticity": "a guess", "damping": "another"})", "[]"), "'source' is neither"},
          {R"({"youngs_modulus_pa": 1e10, "density_kg_per_m3": 800, "poisson_ratio": 0.3})",
           "no damping"},
          {std::string((1 << 20) + 1, ' '), "too large"}}) {
        const auto refused = parseMaterial(text, "folder/jade.json");
        REQUIRE_FALSE(refused);
        CHECK_THAT(refused.error().message, StartsWith("folder/jade.json: "));
        CHECK_THAT(refused.error().message, ContainsSubstring(fault));
    }
}

TEST_CASE("Any damage to a material file gives a valid material or one short sentence") {
    std::mt19937 random(7);
    const auto below = [&](std::size_t count) { return random() % count; };
    const char* const tokens[] = {
        "{",      "}",  "[",       ":",    ",",    "null",      "-1e308",
        "1e-320", "\"", "\\u0000", "true", "\xff", "\"name\":", "999999999999999999999"};
    std::size_t refused = 0;
    for (int round = 0; round < 20000; ++round) {
        auto text = good;
        for (std::size_t change = 0; change <= below(3); ++change) {
            const auto place = below(text.size());
            switch (below(4)) {
            case 0:
                text[place] = static_cast<char>(random());
                break;
            case 1:
                text.erase(place, 1 + below(20));
                break;
            case 2:
                text.insert(place, tokens[below(std::size(tokens))]);
                break;
            default:
                text.insert(place, text.substr(below(text.size()), below(40)));
                break;
            }
        }
        const auto material = parseMaterial(text, "fuzz.json");
        if (material) {
            CHECK(validated(*material));
            continue;
        }
        ++refused;
        const auto& sentence = material.error().message;
        CHECK_THAT(sentence, StartsWith("fuzz.json: "));
        CHECK(sentence.size() < 300);
        CHECK(sentence.find('\n') == std::string::npos);
    }
    CHECK(refused > 10000);
}

TEST_CASE("A list of materials is refused if two names are equal or one is missing") {
    const auto list = [](const std::string& entries) {
        return parseMaterialList(
            R"({"format": "idiophone-materials", "version": 1, "materials": [)" + entries + "]}",
            "list.json");
    };
    REQUIRE(list(good));
    CHECK(list(good)->size() == 1);
    CHECK_THAT(list(good + "," + good).error().message, ContainsSubstring("two materials 'Jade'"));
    CHECK_THAT(list(with("\"name\": \"Jade\",", "")).error().message, ContainsSubstring("no name"));
    CHECK_THAT(parseMaterialList(good, "list.json").error().message,
               ContainsSubstring("not a list of materials"));
}

TEST_CASE("A folder returns its materials by name, and a sentence for each invalid file") {
    const auto place = folder("materials");
    write(place / "b.json", with("Jade", "Amber"));
    write(place / "a.json", good);
    write(place / "broken.json", "{");
    write(place / "notes.txt", "no material");
    std::filesystem::create_directory(place / "folder.json");
    const auto found = readMaterialFolder(place);
    REQUIRE(found.materials.size() == 2);
    CHECK(found.materials[0].name == "Amber");
    CHECK(found.materials[1].name == "Jade");
    REQUIRE(found.faults.size() == 2);
    CHECK_THAT(found.faults[0].message, StartsWith((place / "broken.json").string() + ": "));
    CHECK_THAT(found.faults[1].message, ContainsSubstring("directory"));
    CHECK(readMaterialFolder(place / "nowhere").materials.empty());
    CHECK(readMaterialFolder(place / "nowhere").faults.empty());
    CHECK(readMaterialFolder({}).materials.empty());
}

#if defined(__linux__)
TEST_CASE("A damaged user file is named when its material is requested") {
    const char* text = std::getenv("XDG_CONFIG_HOME");
    const std::string configured = text != nullptr ? text : "";
    const auto settings = folder("settings");
    const auto materials = settings / "Idiophone" / "Materials";
    std::filesystem::create_directories(materials);
    write(materials / "jade.json", good);
    write(materials / "amber.json", "{");
    setenv("XDG_CONFIG_HOME", settings.c_str(), 1);
    CHECK(findAnyMaterial("jade"));
    CHECK_THAT(findAnyMaterial("Amber").error().message,
               StartsWith((materials / "amber.json").string() + ": it is not JSON"));
    CHECK_THAT(findAnyMaterial("Pearl").error().message, StartsWith("There is no material"));
    unsetenv("XDG_CONFIG_HOME");
    if (!configured.empty())
        setenv("XDG_CONFIG_HOME", configured.c_str(), 1);
}

TEST_CASE("The user's folder is in $XDG_CONFIG_HOME, or else in ~/.config") {
    const auto value = [](const char* name) {
        const char* text = std::getenv(name);
        return std::string(text != nullptr ? text : "");
    };
    const auto configured = value("XDG_CONFIG_HOME"), home = value("HOME");
    setenv("HOME", "/home/ann", 1);
    unsetenv("XDG_CONFIG_HOME");
    CHECK(userMaterialFolder() == "/home/ann/.config/Idiophone/Materials");
    setenv("XDG_CONFIG_HOME", "/settings", 1);
    CHECK(userMaterialFolder() == "/settings/Idiophone/Materials");
    unsetenv("XDG_CONFIG_HOME");
    unsetenv("HOME");
    CHECK(userMaterialFolder().empty());
    setenv("HOME", home.c_str(), 1);
    if (!configured.empty())
        setenv("XDG_CONFIG_HOME", configured.c_str(), 1);
}
#endif
