// Tests how the settings of an import hold an object.
#include "Plugin/HeldParts.h"

#include "Geometry/ParametricMesh.h"
#include "Object/MaterialFile.h"
#include "Plugin/ObjectWorkshop.h"
#include "Support/ImportedFiles.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;
using Kind = HeldSettings::Kind;

namespace {

constexpr double lengthMetres = 0.03, heightMetres = 0.0015;

std::shared_ptr<const ModalObject> wholeObject(ObjectWorkshop& workshop) {
    std::shared_ptr<const ModalObject> object;
    const auto take = [&] {
        if (auto product = workshop.takeProduct(); product && !product->isPreview)
            object = product->object;
    };
    waitUntil([&] { return !workshop.status().isWorking(); }, take);
    take();
    INFO(workshop.status().error);
    REQUIRE(object != nullptr);
    return object;
}

Mesh plate() {
    return sheetMesh(0.02, 0.012, 100);
}

/// The plate in millimetres, with a group at its right end.
std::filesystem::path groupedPlate() {
    const auto mesh = plate();
    std::string vertices, body = "g body\n", end = "g end\n";
    for (const auto& v : mesh.vertices.rowwise())
        vertices += "v " + std::to_string(1000 * v(0)) + ' ' + std::to_string(1000 * v(1)) + " 0\n";
    for (const auto& f : mesh.faces.rowwise()) {
        double right = 0;
        for (const int vertex : f)
            right = std::max(right, mesh.vertices(vertex, 0));
        (right > 0.0099 ? end : body) += "f " + std::to_string(f(0) + 1) + ' ' +
                                         std::to_string(f(1) + 1) + ' ' + std::to_string(f(2) + 1) +
                                         '\n';
    }
    return writtenFile("grouped.obj", "o plate\n" + vertices + body + end);
}

float lowestX(const ModalObject& object) {
    float lowest = 1;
    for (const auto vertex : object.clampedVertices)
        lowest = std::min(lowest, object.vertices[3 * static_cast<std::size_t>(vertex)]);
    return lowest;
}

} // namespace

TEST_CASE("The ends are those of the longest side, and ends and places follow the size") {
    const Mesh tall = boxMesh({0.1, 0.2, 0.4}, {1, 1, 1});
    for (const double scale : {1.0, 25.4}) {
        const Mesh mesh{scale * tall.vertices, tall.faces};
        const auto clamps = [&](Kind kind) { return supportOf({.kind = kind}, {}, mesh)->clamps; };
        CHECK(isClamped(clamps(Kind::lowEnd), {0, 0, -0.2 * scale}));
        CHECK_FALSE(isClamped(clamps(Kind::lowEnd), {0, 0, -0.198 * scale}));
        CHECK(isClamped(clamps(Kind::highEnd), {0.05 * scale, 0.1 * scale, 0.2 * scale}));
        CHECK_FALSE(isClamped(clamps(Kind::highEnd), {0, 0, -0.2 * scale}));
        const auto balls =
            supportOf({.kind = Kind::places, .places = {{0.25, 0.5, 1}}}, {}, mesh)->balls;
        REQUIRE(balls.size() == 1);
        CHECK((balls[0].centreMetres - scale * Eigen::Vector3d(0.05, 0.1, 0.2)).norm() < 1e-9);
        CHECK_THAT(balls[0].radiusMetres, WithinRel(0.012 * scale, 1e-9));
    }
    CHECK_FALSE(supportOf({}, {}, tall)->holds());
    CHECK_FALSE(supportOf({.kind = Kind::places}, {}, tall)->holds());
    CHECK(supportOf({.kind = Kind::lowEnd, .quality = -1}, {}, tall).error().message ==
          "The quality factor of the support must not be negative.");
}

TEST_CASE("A bar held at an end in the window has a cantilever's pitch within 1 %, and its support "
          "the wanted quality factor") {
    ObjectWorkshop workshop;
    const auto file = meshFile("bar.obj", boxMesh({lengthMetres, 0.003, heightMetres}, {20, 2, 1}));
    workshop.open(file, {.held = {.kind = Kind::lowEnd, .quality = 200}});
    const auto object = wholeObject(workshop);
    constexpr double beta = 1.87510407 / lengthMetres;
    const auto& material = object->material;
    const double wantedOmega = beta * beta * heightMetres *
                               std::sqrt(material.youngsModulusPa / (12 * material.densityKgPerM3));
    CHECK_THAT(std::sqrt(object->eigenvalues[0]), WithinRel(wantedOmega, 0.01));
    double least = 1e9;
    for (std::size_t mode = 0; mode < 4; ++mode)
        least = std::min(least, std::sqrt(object->eigenvalues[mode]) /
                                    (2 * object->extraDecaysPerSecond[mode]));
    CHECK_THAT(least, WithinRel(200, 1e-9));
}

TEST_CASE("A named group of a file in millimetres is held, also after its size has changed") {
    ObjectWorkshop workshop;
    workshop.open(groupedPlate(), {.unit = "mm"});
    CHECK(wholeObject(workshop)->clampedVertices.empty());
    CHECK(workshop.status().groups == std::vector<std::string>{"body", "end"}); // not the whole
    CHECK_FALSE(workshop.status().wasHeld);
    for (const double longest : {0.0, 0.03}) {
        workshop.analyseAgain({.unit = "mm",
                               .longestMetres = longest,
                               .held = {.kind = Kind::group, .group = "end"}});
        const auto object = wholeObject(workshop);
        CHECK_FALSE(object->clampedVertices.empty());
        CHECK(lowestX(*object) > 0.3f * float(longest > 0 ? longest : 0.02));
    }
    workshop.analyseAgain({.held = {.kind = Kind::group, .group = "foot"}});
    waitUntil([&] { return !workshop.status().isWorking(); });
    CHECK(workshop.status().error == "grouped.obj: There is no group 'foot' in the mesh; its "
                                     "groups are 'plate', 'body', 'end'.");
}

TEST_CASE("Painted places are held in the preview and in the whole object") {
    ObjectWorkshop workshop;
    HeldSettings held{.kind = Kind::places};
    for (double y = 0; y <= 0.6; y += 0.015)
        held.places.push_back({1, y, 0});
    workshop.open(meshFile("plate.obj", plate()), {.held = held});
    std::size_t products = 0;
    const auto take = [&] {
        if (const auto product = workshop.takeProduct()) {
            ++products;
            CHECK(product->object->clampedVertices.size() > 2);
            CHECK(lowestX(*product->object) > 0.0093f);
        }
    };
    waitUntil([&] { return !workshop.status().isWorking(); }, take);
    take();
    CHECK(products > 0);
}

TEST_CASE("An object that was held is analysed again as before, with another support") {
    ObjectWorkshop workshop;
    workshop.open(meshFile("plate.obj", plate()), {.held = {.kind = Kind::highEnd, .quality = 40}});
    const auto object = wholeObject(workshop);
    CHECK(object->extraDecaysPerSecond.size() == object->modeCount());
    workshop.analyse(*object, {.held = {.kind = Kind::asBefore}});
    const auto again = wholeObject(workshop);
    CHECK(workshop.status().wasHeld);
    CHECK(again->extraDecaysPerSecond.empty()); // the support is rigid now
    CHECK_THAT(again->eigenvalues[0], WithinRel(object->eigenvalues[0], 0.005));
}
