// Tests default strike places on an object, and paths between metres and the object's box.
#include "Instrument/SingleObjectMap.h"
#include "Instrument/ObjectLibrary.h"

#include "Geometry/ParametricMesh.h"
#include "Instrument/Instrument.h"
#include "Instrument/ObjectBox.h"
#include "Support/SyntheticObject.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>

using namespace idiophone;
using namespace idiophone::test;
using Path = std::vector<std::array<double, 3>>;

namespace {

/// An object with one mode, which lifts one end of the mesh along z.
ModalObject objectOf(const Mesh& mesh) {
    auto object = syntheticObject({300});
    object.vertices.clear();
    object.faces.clear();
    object.shapes.clear();
    object.shapeVertices.clear();
    const double reach = mesh.vertices.col(0).maxCoeff();
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        for (int axis = 0; axis < 3; ++axis)
            object.vertices.push_back(static_cast<float>(mesh.vertices(v, axis)));
        object.shapeVertices.push_back(v);
        object.shapes.insert(object.shapes.end(),
                             {0, 0, static_cast<float>(mesh.vertices(v, 0) / reach)});
    }
    for (const auto& face : mesh.faces.rowwise())
        object.faces.insert(object.faces.end(), face.begin(), face.end());
    return object;
}

} // namespace

TEST_CASE("The path over a ball runs from side to side over its top") {
    const auto ball = objectOf(icosphereMesh(0.1, 3));
    const auto path = pathOverTop(ball);
    REQUIRE(path.size() == 33);
    for (const auto& [x, y, z] : path) {
        CHECK(std::abs(std::hypot(x, y, z) - 1) < 0.02);
        CHECK(z > 0);
    }
    CHECK(path.front()[0] < -0.95);
    CHECK(path.back()[0] > 0.95);
    CHECK(path[16][2] > 0.98);
}

TEST_CASE("A ring's path goes half round it without a jump, on the side visible from above") {
    const auto path = pathOverTop(objectOf(torusMesh(0.1, 0.01, 40, 12)));
    REQUIRE(path.size() > 10);
    CHECK(path.front()[0] * path.back()[0] < -0.9);
    for (std::size_t i = 0; i < path.size(); ++i) {
        const auto& [x, y, z] = path[i];
        CHECK(std::hypot(x, y) > 0.77); // the ring consists of 40 straight pieces
        CHECK(z > -0.1);
        if (i > 0)
            CHECK(std::hypot(x - path[i - 1][0], y - path[i - 1][1]) < 0.3);
    }
}

TEST_CASE("The path over an upright object leads upwards") {
    Mesh pole = boxMesh({0.02, 0.02, 0.5}, {2, 2, 20});
    const auto path = pathOverTop(objectOf(pole));
    CHECK(path.front()[2] < -0.95);
    CHECK(path.back()[2] > 0.95);
    for (const auto& [x, y, z] : path)
        CHECK(y == -1);
}

TEST_CASE(
    "Every layout of an object can be built, and scaled objects are struck where they move most") {
    const auto object = objectOf(sheetMesh(0.3, 0.1, 100));
    ObjectLibrary library;
    const auto kept = library.add("sheet", object);
    const auto scaled = singleObjectMap(object, "sheet", KeyMapKind::scaled);
    CHECK(std::abs(scaled.strikeAt.front() - 0.5) > 0.35);
    CHECK(Instrument::build(scaled, library));
    CHECK(Instrument::build(singleObjectMap(object, "sheet", KeyMapKind::zones), library));
}

TEST_CASE("A path in metres is recovered, clamped to the object's box and to 1000 points") {
    const auto object = objectOf(icosphereMesh(0.1, 2));
    const Path drawn{{-0.05, 0.01, 0.08}, {0.04, 0.02, 0.09}};
    KeyMap map;
    map.strikePath = relativePath(object, drawn);
    const auto back = pathMetres(object, map);
    REQUIRE(back.size() == 2);
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            CHECK(std::abs(back[i][axis] - drawn[i][axis]) < 1e-9);

    constexpr double infinity = std::numeric_limits<double>::infinity();
    CHECK(relativePath(object, {}).empty());
    CHECK(relativePath(object, {{infinity, 0, 0}, {0, std::nan(""), 0}}).empty());
    CHECK(relativePath(object, {{7, -7, 0}}) ==
          Path{{1, -1, relativePath(object, {{0, 0, 0}})[0][2]}});
    Path endless;
    for (int i = 0; i < 5000; ++i)
        endless.push_back({0.1 * i / 4999, 0, 0});
    const auto kept = relativePath(object, endless);
    REQUIRE(kept.size() == 1000);
    CHECK(kept.front() == relativePath(object, {endless.front()})[0]);
    CHECK(kept.back() == relativePath(object, {endless.back()})[0]);
    // A flat sheet has no extent along its height.
    CHECK(relativePath(objectOf(sheetMesh(0.2, 0.1, 50)), {{0, 0, 5}})[0][2] == 0);
}
