#include "Geometry/Decimation.h"
#include "Geometry/MeshCheck.h"
#include "Geometry/MeshRepair.h"
#include "Geometry/Remesh.h"
#include "Geometry/TestMeshes.h"

#include <catch2/catch_test_macros.hpp>
#include <ctime>
#include <limits>
#include <string>

using namespace idiophone;
using namespace idiophone::test;

namespace {

struct Case {
    std::string name;
    Mesh mesh;
};

double uniform(std::mt19937& random) {
    return static_cast<double>(random()) / 4294967296.0;
}

Mesh shaken(Mesh mesh, std::mt19937& random, double amount) {
    for (double& coordinate : mesh.vertices.reshaped())
        coordinate += amount * (uniform(random) - 0.5);
    return mesh;
}

Mesh turnedAtRandom(Mesh mesh, std::mt19937& random) {
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        if (random() % 2 == 0)
            std::swap(mesh.faces(face, 0), mesh.faces(face, 1));
    return mesh;
}

/// Rounds coordinates to a coarse lattice: points coincide, faces overlap or become collinear.
Mesh snapped(Mesh mesh, double step) {
    mesh.vertices = (mesh.vertices / step).array().round().matrix() * step;
    return mesh;
}

Mesh slivers(std::mt19937& random, int count, double width) {
    Mesh mesh = randomSoup(random, 3 * count, count);
    for (int face = 0; face < count; ++face) {
        mesh.faces.row(face) << 3 * face, 3 * face + 1, 3 * face + 2;
        mesh.vertices.row(3 * face + 2) =
            mesh.vertices.row(3 * face) +
            uniform(random) * (mesh.vertices.row(3 * face + 1) - mesh.vertices.row(3 * face));
        mesh.vertices(3 * face + 2, 0) += width;
    }
    return mesh;
}

Mesh withHoles(const Mesh& mesh, std::mt19937& random) {
    Mesh result{mesh.vertices, Eigen::MatrixXi(0, 3)};
    result.faces.resize(mesh.faceCount(), 3);
    Eigen::Index kept = 0;
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        if (random() % 4 != 0)
            result.faces.row(kept++) = mesh.faces.row(face);
    result.faces.conservativeResize(kept, Eigen::NoChange);
    return result;
}

std::vector<Case> shapes() {
    const auto cube = boxMesh({1, 1, 1}, {2, 2, 2}), small = boxMesh({0.3, 0.3, 0.3}, {1, 1, 1});
    const auto ball = icosphereMesh(1, 2);
    return {{"ball", ball},
            {"inside-out cube", insideOut(cube)},
            {"cubes at an edge", joined(cube, moved(cube, {1, 1, 0}))},
            {"cubes at a vertex", joined(cube, moved(cube, {1, 1, 1}))},
            {"cubes at a face", joined(cube, moved(cube, {1, 0, 0}))},
            {"cubes that cut", joined(cube, moved(cube, {0.4, 0.3, 0.2}))},
            {"the same cube twice", joined(cube, cube)},
            {"nested balls", joined(ball, icosphereMesh(0.5, 1))},
            {"cube in cube, touching", joined(cube, moved(small, {0.35, 0, 0}))},
            {"T-junctions", tJunctionCube(2)},
            {"Möbius strip", moebiusStrip(20, 3)},
            {"Klein bottle", kleinBottle(16, 10)},
            {"book of 3", book(3)},
            {"book of 8", book(8)},
            {"book of 200", book(200)},
            {"hemisphere", openHemisphere(1, 5)},
            {"bowl", bowl(1, 0.02, 6)},
            {"one triangle", {Eigen::MatrixXd::Identity(3, 3), Eigen::RowVector3i(0, 1, 2)}}};
}

std::vector<Case> cases() {
    std::vector<Case> all = shapes();
    std::mt19937 random(20240601);
    for (const auto& [name, mesh] : shapes()) {
        all.push_back({name + ", shaken hard", shaken(mesh, random, 0.5)});
        all.push_back({name + ", shaken a hair", shaken(mesh, random, 1e-7)});
        all.push_back({name + ", turned at random", turnedAtRandom(mesh, random)});
        all.push_back({name + ", as soup", soupOf(mesh)});
        all.push_back({name + ", snapped", snapped(shaken(mesh, random, 0.3), 0.25)});
        all.push_back({name + ", with holes", withHoles(mesh, random)});
        all.push_back({name + ", flat",
                       {mesh.vertices * Eigen::Vector3d(1, 1, 1e-9).asDiagonal(), mesh.faces}});
        all.push_back({name + ", huge", {mesh.vertices * 1e8, mesh.faces}});
        all.push_back({name + ", tiny", {mesh.vertices * 1e-8, mesh.faces}});
        all.push_back({name + ", too huge", {mesh.vertices * 1e300, mesh.faces}});
        all.push_back({name + ", too tiny", {mesh.vertices * 1e-300, mesh.faces}});
        all.push_back({name + ", far away", moved(mesh, {1e8, -1e8, 1e8})});
        auto broken = mesh;
        broken.vertices(0, 1) = random() % 2 == 0 ? std::numeric_limits<double>::quiet_NaN()
                                                  : std::numeric_limits<double>::infinity();
        all.push_back({name + ", not finite", broken});
    }
    for (int i = 0; i < 60; ++i) {
        const int vertices = 4 + static_cast<int>(random() % 60);
        const auto soup = randomSoup(random, vertices, 5 + static_cast<int>(random() % 200));
        all.push_back({"random soup " + std::to_string(i), soup});
        all.push_back({"snapped soup " + std::to_string(i), snapped(soup, 0.25)});
    }
    for (int i = 0; i < 20; ++i)
        all.push_back(
            {"slivers " + std::to_string(i), slivers(random, 20, std::pow(10.0, -1 - 0.6 * i))});
    return all;
}

bool hasDegenerateFace(const Mesh& mesh) {
    return !(worstAspect(mesh) < 2e10);
}

/// Checks that the error is one sentence.
void checkSentence(const Error& error) {
    CHECK(error.message.size() > 10);
    CHECK(error.message.back() == '.');
    CHECK(error.message.find('\n') == std::string::npos);
}

void checkManifold(const Result<Mesh>& result) {
    if (!result) {
        checkSentence(result.error());
        return;
    }
    CHECK(result->faceCount() > 0);
    CHECK(result->vertices.allFinite());
    CHECK(isOrientedManifold(*result));
    CHECK_FALSE(hasDegenerateFace(*result));
}

void tryEverything(const Mesh& mesh) {
    const auto repaired = repairMesh(mesh);
    if (!repaired) {
        checkSentence(repaired.error());
        CHECK_FALSE(remesh(mesh, 0.1));
        CHECK_FALSE(decimate(mesh, 50));
        return;
    }
    CHECK_FALSE(hasDegenerateFace(repaired->mesh));
    CHECK(repaired->vertexOfInput.size() == static_cast<std::size_t>(mesh.vertexCount()));
    const auto again = repairMesh(repaired->mesh);
    CHECK((again && again->report.degenerateFaces + again->report.duplicateFaces == 0));
    const auto cut = repairMesh(mesh, {.cutIntoManifold = true});
    REQUIRE(cut);
    CHECK(isOrientedManifold(cut->mesh));
    CHECK_FALSE(hasDegenerateFace(cut->mesh));
    const Eigen::RowVector3d extent =
        repaired->mesh.vertices.colwise().maxCoeff() - repaired->mesh.vertices.colwise().minCoeff();
    if (const auto check = checkMesh(repaired->mesh); check.isSolid())
        CHECK(check.volumeM3 <= 1.001 * extent.prod());
    const double size = boundingDiagonalMetres(repaired->mesh);
    for (const double share : {0.07, 0.3})
        checkManifold(remesh(mesh, share * size));
    for (const int budget : {4, 30}) {
        const auto decimated = decimate(mesh, budget);
        checkManifold(decimated);
        if (decimated)
            CHECK(decimated->vertexCount() <= budget);
    }
}

/// Tries every fourth mesh from `first` on, so that each test stays short.
void tryEveryFourth(std::size_t first) {
    const auto all = cases();
    REQUIRE(all.size() > 380);
    for (std::size_t i = first; i < all.size(); i += 4) {
        INFO(all[i].name);
        const auto start = std::clock(); // of the processor, so that other programs do not count
        tryEverything(all[i].mesh);
        CHECK(std::clock() - start < 20 * CLOCKS_PER_SEC);
    }
}

} // namespace

TEST_CASE("Strange meshes give a good result or a one-sentence error: first quarter") {
    tryEveryFourth(0);
}
TEST_CASE("Strange meshes give a good result or a one-sentence error: second quarter") {
    tryEveryFourth(1);
}
TEST_CASE("Strange meshes give a good result or a one-sentence error: third quarter") {
    tryEveryFourth(2);
}
TEST_CASE("Strange meshes give a good result or a one-sentence error: last quarter") {
    tryEveryFourth(3);
}
