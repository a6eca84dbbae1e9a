// Tests of how materials and mallets look.
#include "Editor/MalletAppearance.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;

namespace {

/// The figures of a library material under another name, as the custom material has them.
Material figuresOf(const char* name) {
    auto material = *findMaterial(name);
    material.name = "Custom";
    material.grain.reset();
    return material;
}

float difference(const Appearance& a, const Appearance& b) {
    float largest = 0;
    for (std::size_t channel = 0; channel < a.colour.size(); ++channel)
        largest = std::max(largest, std::abs(a.colour[channel] - b.colour[channel]));
    return largest;
}

const Mallet& malletNamed(std::string_view name) {
    return *std::ranges::find(malletRack(), name, &Mallet::name);
}

} // namespace

TEST_CASE("A library material looks like its entry") {
    CHECK(appearanceOf(*findMaterial("Rosewood")) ==
          Appearance{Finish::wood, channelsOf(0x6b3324)});
    CHECK(appearanceOf(*findMaterial("Bell glass")).finish == Finish::glass);
    CHECK(appearanceOf(*findMaterial("Slate")).finish == Finish::stone);
    CHECK(appearanceOf(*findMaterial("Porcelain")).finish == Finish::ceramic);
    CHECK(appearanceOf(*findMaterial("Brass")).finish == Finish::metal);
    CHECK(appearanceOf(*findMaterial("Nylon")).finish == Finish::plastic);
}

TEST_CASE("Custom figures look like the library material that has them") {
    for (const char* name : {"Rosewood", "Aluminium", "Copper", "Granite", "Bell glass", "Maple"}) {
        INFO(name);
        const auto custom = appearanceOf(figuresOf(name));
        const auto known = appearanceOf(*findMaterial(name));
        CHECK(custom.finish == known.finish);
        CHECK(difference(custom, known) < 0.03f);
    }
}

TEST_CASE("The colour follows small changes of figures without steps") {
    auto material = figuresOf("Brass");
    auto last = appearanceOf(material);
    float moved = 0;
    for (int step = 0; step < 200; ++step) {
        material.youngsModulusPa *= 1.0033;
        const auto next = appearanceOf(material);
        REQUIRE(next.finish == Finish::metal);
        CHECK(difference(last, next) < 0.05f);
        moved += difference(last, next);
        last = next;
    }
    CHECK(moved > 0.05f);
}

TEST_CASE("A material with a grain is wood, whatever its figures") {
    auto material = figuresOf("Steel");
    material.grain = findMaterial("Rosewood")->grain;
    CHECK(appearanceOf(material).finish == Finish::wood);
}

TEST_CASE("Mallets look like their heads") {
    CHECK(appearanceOf(malletNamed("Yarn")).finish == Finish::cloth);
    CHECK(appearanceOf(malletNamed("Hard rubber")).finish == Finish::plastic);
    CHECK(appearanceOf(malletNamed("Wood")).finish == Finish::wood);
    CHECK(appearanceOf(malletNamed("Brass")) == Appearance{Finish::metal, channelsOf(0xd0a84a)});
}
