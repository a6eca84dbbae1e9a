#include "Support/SyntheticObject.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <limits>

using namespace idiophone;
using Catch::Matchers::ContainsSubstring;
using test::syntheticObject;

TEST_CASE("A well-formed object passes validation unchanged") {
    const auto object = validated(syntheticObject({100, 200, 300}));
    REQUIRE(object);
    CHECK(object->modeCount() == 3);
    CHECK(object->shapeVertexCount() == 4);
    CHECK(object->shapesAt(2).size() == 9);
}

TEST_CASE("Each malformed field is named") {
    const auto refuse = [](auto change, const char* sentence) {
        INFO(sentence);
        auto object = syntheticObject({100, 200, 300});
        change(object);
        const auto result = validated(object);
        REQUIRE_FALSE(result);
        CHECK_THAT(result.error().message, ContainsSubstring(sentence));
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    refuse(
        [](auto& o) {
            o.eigenvalues.clear();
            o.shapes.clear();
        },
        "no modes");
    refuse(
        [](auto& o) {
            o.shapeVertices.clear();
            o.shapes.clear();
        },
        "no vertex");
    refuse([](auto& o) { o = syntheticObject(std::vector<double>(maximumObjectModes + 1, 440.0)); },
           "more than 65536 modes");
    refuse([](auto& o) { o.shapes.pop_back(); }, "size of the mode shapes");
    refuse(
        [](auto& o) {
            o.body = BodyKind::shell;
            o.thicknessMetres = 1e-10;
        },
        "less than a nanometre");
    refuse([](auto& o) { o.bending = {1}; }, "bending parts");
    refuse([](auto& o) { o.bending = {1, -1, 1}; }, "bending part");
    refuse([](auto& o) { o.clampedVertices = {1, 0}; }, "list of clamped vertices");
    refuse([](auto& o) { o.clampedVertices = {-1}; }, "list of clamped vertices");
    refuse([](auto& o) { o.decaysPerSecond = {1}; }, "decays are not one for each mode");
    refuse([](auto& o) { o.decaysPerSecond = {1, 0, 1}; }, "decay is not between");
    refuse([](auto& o) { o.extraDecaysPerSecond = {1}; }, "extra decays are not one for each");
    refuse([](auto& o) { o.extraDecaysPerSecond = {1, -1, 1}; }, "extra decay is not between");
    refuse([](auto& o) { o.gains = {1}; }, "gains are not one for each");
    refuse([](auto& o) { o.gains = {1, 2000, 1}; }, "gain is beyond");
    refuse([&](auto& o) { o.decaysPerSecond = {1, nan, 1}; }, "decay is not between");
    refuse(
        [](auto& o) {
            o.decaysPerSecond = {1, 2, 3};
            o.material.damping = {};
        },
        "no damping");
    refuse([&](auto& o) { o.eigenvalues[1] = nan; }, "not a finite number");
    refuse([](auto& o) { o.eigenvalues[0] = -1; }, "not positive");
    refuse([](auto& o) { std::swap(o.eigenvalues[0], o.eigenvalues[2]); }, "ascending");
    refuse([](auto& o) { o.eigenvalues[2] = 1e30; }, "1 GHz");
    refuse([](auto& o) { o.eigenvalues[0] = 1e-5; }, "1 mHz");
    refuse(
        [](auto& o) {
            o.decaysPerSecond = {1, 2, 3};
            o.material.damping = {.fluidPerSecond = 1e-12};
        },
        "more than 1e12 times");
    for (const float shape : {nan, infinity, 1.01e8f, -3e20f})
        refuse([=](auto& o) { o.shapes[5] = shape; }, "mode shape is not between -1e8 and 1e8");
    for (const float weight : {1.01e8f, -3e20f})
        refuse(
            [=](auto& o) {
                o.radiation = {{{1, 0, 0}}, {1}, {1, weight, 3}};
            },
            "weight of the radiation is not a number up to 1e8");
    for (const float coordinate : {nan, 1.1e6f, -1e20f})
        refuse([=](auto& o) { o.vertices[5] = coordinate; }, "vertex does not lie within 1000 km");
    refuse([](auto& o) { o.vertices.pop_back(); }, "threes");
    refuse([](auto& o) { o.faces[0] = 4; }, "face");
    refuse([](auto& o) { o.faces[0] = -1; }, "face");
    refuse([](auto& o) { o.shapeVertices[3] = 7; }, "does not exist");
    refuse([](auto& o) { std::swap(o.shapeVertices[0], o.shapeVertices[1]); }, "ascending order");
    refuse([](auto& o) { o.radiation.frequencyRatios = {1}; }, "radiation is not directions");
    refuse(
        [](auto& o) {
            o.radiation = {{{1, 0, 0}}, {1}, {1, 2}};
        },
        "radiation is not directions");
    refuse([](auto& o) { o.radiation = {{{1, 1, 0}}, {1}, {1, 2, 3}}; }, "unit vector");
    refuse([](auto& o) { o.thicknessMetres = 0; }, "thickness");
    refuse([](auto& o) { o.thicknessMetres = 1e7; }, "thickness");
    refuse([](auto& o) { o.bandHz = 0; }, "band");
    for (const double massKg : {-1.0, 0.0, 1e-19, 1e24})
        refuse([=](auto& o) { o.mass.massKg = massKg; }, "mass is not between");
    for (const double metres : {double{nan}, 1.1e6})
        refuse([=](auto& o) { o.mass.centreMetres[1] = metres; }, "centre does not lie");
    for (const double inertia : {double{nan}, 1.3e13})
        refuse([=](auto& o) { o.mass.inertiaKgM2[4] = inertia; }, "inertia");
    refuse([](auto& o) { o.material.densityKgPerM3 = 0; }, "density");
}

TEST_CASE("An object at the limits of all ranges is accepted") {
    auto object = syntheticObject({0.00101, 999e6}, {largestShape, -largestShape});
    object.decaysPerSecond = {1e-300, 1e9};
    object.vertices[3] = -1e6f;
    object.radiation = {{{1, 0, 0}}, {1}, {largestShape, -largestShape}};
    for (const double massKg : {1e-18, 1e23}) {
        object.mass = {
            .massKg = massKg, .centreMetres = {1e6, 0, 0}, .inertiaKgM2 = {1.1e13 * massKg}};
        const auto result = validated(object);
        INFO((result ? "" : result.error().message));
        CHECK(result);
    }
    CHECK(validated(syntheticObject(std::vector<double>(maximumObjectModes, 440.0))));
}

TEST_CASE("A mode's damping scale is its measured decay over half the law's damping") {
    auto object = syntheticObject({100, 200, 300});
    CHECK(object.dampings().empty());
    CHECK(object.damping(1) == ModeDamping{});
    CHECK(object.decayPerSecond(1) == object.material.damping.perSecond(object.eigenvalues[1]) / 2);
    object.decaysPerSecond = {1, 5, 9};
    CHECK(object.decayPerSecond(1) == 5);
    CHECK(object.damping(1).scale ==
          Catch::Approx(2 * 5 / object.material.damping.perSecond(object.eigenvalues[1])));
}

TEST_CASE("An extra decay adds to the material's or the measured one") {
    auto object = syntheticObject({100, 200, 300});
    object.extraDecaysPerSecond = {0, 2, 4};
    CHECK(object.decayPerSecond(0) == object.material.damping.perSecond(object.eigenvalues[0]) / 2);
    CHECK(object.decayPerSecond(1) ==
          object.material.damping.perSecond(object.eigenvalues[1]) / 2 + 2);
    object.decaysPerSecond = {1, 5, 9};
    CHECK(object.decayPerSecond(2) == 13);
    CHECK(object.dampings()[2].extraPerSecond == 4);
}

TEST_CASE("Vertex normals point outward from counter-clockwise faces") {
    const auto normals = vertexNormals(syntheticObject({100}));
    for (std::size_t vertex = 0; vertex < 4; ++vertex) {
        CHECK(normals[vertex * 3] == 0);
        CHECK(normals[vertex * 3 + 1] == 0);
        CHECK(normals[vertex * 3 + 2] == Catch::Approx(1));
    }
}

TEST_CASE("The nearest row belongs to the nearest vertex with shapes") {
    auto object = syntheticObject({100});
    object.shapeVertices = {1, 3};
    object.shapes.resize(6);
    CHECK(nearestShapeRow(object, {0.9, 0.1, 0.3}) == 0);
    CHECK(nearestShapeRow(object, {0.1, 0.9, 0.3}) == 1);
}
