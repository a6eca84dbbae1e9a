#include "Instrument/SettingsOfParameters.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using Catch::Approx;

TEST_CASE("Only the five figures of the custom material act live") {
    using enum ParameterId;
    ParameterValues values;
    values.set(lossFactor, 0.01);
    CHECK_FALSE(synthesisSettings(values).material); // each object keeps its own material
    values.set(material, customMaterial);
    values.set(youngsModulus, 70);
    values.set(density, 2700);
    values.set(fluidDamping, 0.5);
    values.set(viscoelasticDamping, 0.01);
    const auto live = synthesisSettings(values).material;
    REQUIRE(live);
    CHECK(live->youngsModulusPa == Approx(70e9));
    CHECK(live->densityKgPerM3 == 2700);
    CHECK(live->damping.fluidPerSecond == 0.5);
    CHECK(live->damping.viscoelasticSeconds == Approx(1e-8));
    CHECK(live->damping.lossFactor == 0.01);
}

TEST_CASE("Every library material has its own damping law as a live material") {
    ParameterValues values;
    int choice = firstLibraryMaterial;
    for (const auto& material : materialLibrary()) {
        values.set(ParameterId::material, choice++);
        const auto live = synthesisSettings(values).material;
        REQUIRE(live);
        CHECK(live->damping == material.damping);
    }
}

TEST_CASE("A material made custom plays with its figures, clamped to the ranges") {
    for (const auto& material : materialLibrary()) {
        INFO(material.name);
        const auto live = synthesisSettings(withCustomMaterial({}, material)).material;
        REQUIRE(live);
        CHECK(live->youngsModulusPa == Approx(material.youngsModulusPa));
        CHECK(live->densityKgPerM3 == Approx(material.densityKgPerM3));
        // A logarithmic range has no zero; its end is a T60 of 23 minutes.
        CHECK(live->damping.fluidPerSecond == std::max(material.damping.fluidPerSecond, 0.01));
        CHECK(live->damping.viscoelasticSeconds ==
              Approx(std::max(material.damping.viscoelasticSeconds, 1e-10)));
        CHECK(live->damping.lossFactor == material.damping.lossFactor);
    }
}

TEST_CASE("A choice made custom sounds as before, whatever its figures were") {
    using enum ParameterId;
    const auto& first = materialLibrary().front();
    const auto& own = materialLibrary().back();
    ParameterValues values;
    values.set(youngsModulus, 1);
    for (const double chosen : {double{ownMaterial}, double{firstLibraryMaterial}}) {
        values.set(material, chosen);
        const auto custom = withCustom(values, *choiceOfFigure(youngsModulus), &own);
        CHECK(static_cast<int>(custom[material]) == customMaterial);
        const auto& source = chosen == double{ownMaterial} ? own : first;
        CHECK(custom == withCustomMaterial(values, source));
        CHECK(custom[mallet] == values[mallet]);
    }
    values.set(mallet, firstRackMallet);
    const auto custom = withCustom(values, *choiceOfFigure(malletMass), &own);
    CHECK(static_cast<int>(custom[mallet]) == customMallet);
    CHECK(custom[malletMass] == Approx(malletRack().front().massKg * 1e3));
    CHECK(custom[material] == values[material]);
    CHECK(custom[youngsModulus] == 1);
    CHECK(choiceOfFigure(level) == nullptr);
}
