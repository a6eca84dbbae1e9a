// Meshes from glTF files: what is read. Its (x, y, z) becomes (x, −z, y).
#include "Geometry/MeshReader.h"

#include "Geometry/MeshRepair.h"
#include "Geometry/MetricMesh.h"
#include "Support/GltfFile.h"
#include "Support/TestFolder.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <fstream>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;
using nlohmann::json;

namespace {

std::filesystem::path written(const std::string& name, const std::string& bytes) {
    const auto path = testFolder() / name;
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

MeshOfFile readFile(const GltfFile& file) {
    const auto read = readMeshFile(written("read.glb", file.glb()));
    INFO((read ? "" : read.error().message));
    REQUIRE(read);
    return *read;
}

/// The unit cube: vertex 4z + 2y + x at (x, y, z).
const std::vector<float> cube{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0,
                              0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
const std::vector<std::uint16_t> cubeTriangles{0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6,
                                               0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7,
                                               0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};

/// Adds a mesh of one cube.
void addCube(GltfFile& file) {
    const int positions = file.addPositions(cube);
    file.addMesh(positions, file.addIndices(cubeTriangles));
}

/// Checks that the mesh is closed and looks outward without having been turned over.
void checkBody(const Mesh& mesh, double volumeM3, int weldedVertices = 0) {
    const auto repaired = repairMesh(mesh);
    REQUIRE(repaired);
    const auto& report = repaired->report;
    CHECK(report.boundaryEdges == 0);
    CHECK(report.flippedFaces == 0);
    CHECK(report.degenerateFaces == 0);
    CHECK(report.nonManifoldEdges == 0);
    CHECK(report.weldedVertices == weldedVertices);
    CHECK(std::abs(signedVolumeM3(repaired->mesh) - volumeM3) < 1e-5 * volumeM3);
}

} // namespace

TEST_CASE("A cube is the same as triangles, strips and fans of glTF, with and without indices") {
    GltfFile file;
    const int positions = file.addPositions(cube);
    file.json["nodes"] = {{{"mesh", 0}}};
    SECTION("triangles") {
        file.addMesh(positions, file.addIndices(cubeTriangles));
        checkBody(readFile(file).mesh, 1);
    }
    SECTION("a strip that repeats vertices to go on elsewhere") {
        file.addMesh(positions,
                     file.addIndices({0, 2, 1, 3, 3, 4, 4, 5, 6, 7, 7, 0, 0, 1, 4, 5, 5,
                                      2, 2, 6, 3, 7, 7, 0, 0, 4, 2, 6, 6, 1, 1, 3, 5, 7}),
                     5);
        const auto mesh = readFile(file).mesh;
        CHECK(mesh.faceCount() == 12);
        checkBody(mesh, 1);
    }
    SECTION("fans that share their vertices") {
        file.addMesh(positions, file.addIndices({0, 2, 3, 1, 5, 4, 6, 2}), 6);
        auto second = file.json["meshes"][0]["primitives"][0];
        second["indices"] = file.addIndices({7, 6, 4, 5, 1, 3, 2, 6});
        file.json["meshes"][0]["primitives"].push_back(second);
        const auto mesh = readFile(file).mesh;
        CHECK(mesh.vertexCount() == 8);
        checkBody(mesh, 1);
    }
    SECTION("no indices") {
        std::vector<float> corners;
        for (const auto vertex : cubeTriangles)
            corners.insert(corners.end(), cube.begin() + 3 * vertex, cube.begin() + 3 * vertex + 3);
        file.addMesh(file.addPositions(corners));
        checkBody(readFile(file).mesh, 1, 28);
    }
}

TEST_CASE("Numbers of a glTF file are read in every type, with gaps, sparse and quantised") {
    GltfFile file;
    file.json["nodes"] = {{{"mesh", 0}}};
    SECTION("indices of one and of four bytes") {
        const int positions = file.addPositions(cube);
        file.addView(std::vector<std::uint8_t>(cubeTriangles.begin(), cubeTriangles.end()));
        file.addMesh(positions, file.addAccessor("SCALAR", 5121, 36));
        checkBody(readFile(file).mesh, 1);
        file.addView(std::vector<std::uint32_t>(cubeTriangles.begin(), cubeTriangles.end()));
        file.addMesh(positions, file.addAccessor("SCALAR", 5125, 36));
        file.json["nodes"] = {{{"mesh", 1}}};
        checkBody(readFile(file).mesh, 1);
    }
    SECTION("positions and normals in turns, behind an offset") {
        std::vector<float> interleaved{7, 7, 7};
        for (std::size_t i = 0; i < cube.size(); i += 3) {
            interleaved.insert(interleaved.end(), {9, 9, 9});
            interleaved.insert(interleaved.end(), cube.begin() + static_cast<std::ptrdiff_t>(i),
                               cube.begin() + static_cast<std::ptrdiff_t>(i) + 3);
        }
        file.addView(interleaved, 24);
        const int positions = file.addAccessor("VEC3", 5126, 8);
        file.json["accessors"][0]["byteOffset"] = 24;
        file.addMesh(positions, file.addIndices(cubeTriangles));
        checkBody(readFile(file).mesh, 1);
    }
    SECTION("a sparse accessor, with and without its own view") {
        auto bent = cube;
        bent[22] = 5;
        const int positions = file.addPositions(bent);
        const int indices = file.addView(std::vector<std::uint8_t>{7});
        const int values = file.addView(std::vector<float>{1, 1, 1});
        file.json["accessors"][0]["sparse"] = {
            {"count", 1},
            {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
            {"values", {{"bufferView", values}}}};
        file.addMesh(positions, file.addIndices(cubeTriangles));
        checkBody(readFile(file).mesh, 1);
        file.json["accessors"][0].erase("bufferView");
        CHECK(readFile(file).mesh.vertices.colwise().sum() == Eigen::RowVector3d(1, -1, 1));
    }
    SECTION("whole numbers, as they are and normalised") {
        std::vector<std::int16_t> shorts;
        for (std::size_t i = 0; i < cube.size(); ++i) {
            shorts.push_back(cube[i] > 0 ? 32767 : -32768);
            if (i % 3 == 2)
                shorts.push_back(0);
        }
        file.addView(shorts, 8);
        const int positions = file.addAccessor("VEC3", 5122, 8);
        file.json["accessors"][0]["normalized"] = true;
        file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
        file.addMesh(positions, file.addIndices(cubeTriangles));
        checkBody(readFile(file).mesh, 8);
        file.json["accessors"][0].erase("normalized");
        checkBody(readFile(file).mesh, std::pow(65535.0, 3));
    }
}

TEST_CASE("Nodes place their meshes, and mirrored ones stay outward") {
    GltfFile file;
    addCube(file);
    file.json["nodes"] = {
        {{"translation", {10, 0, 0}}, {"children", {1}}, {"scale", {1, 2, -1}}},
        {{"mesh", 0}, {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}},
        {{"mesh", 0}, {"matrix", {3, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1}}}};
    file.json["scenes"] = {{{"nodes", json::array()}}, {{"nodes", {0}}}, {{"nodes", {2}}}};
    file.json["scene"] = 1;
    const auto turned = readFile(file).mesh;
    checkBody(turned, 2);
    const auto box = boxOfFaces(turned);
    CHECK(box.min().isApprox(Eigen::Vector3d(9, 0, 0)));
    CHECK((box.max() - Eigen::Vector3d(10, 1, 2)).norm() < 1e-9);
    file.json["scene"] = 2;
    CHECK(boxOfFaces(readFile(file).mesh).max() == Eigen::Vector3d(3, -5, 1));
    SECTION("a file without scenes shows all nodes") {
        file.json.erase("scenes");
        file.json.erase("scene");
        CHECK(readFile(file).mesh.faceCount() == 24);
    }
}

TEST_CASE("Instances are placed, relative to their node") {
    GltfFile file;
    addCube(file);
    const int translations = file.addPositions({0, 0, 0, 5, 0, 0});
    file.addView(std::vector<float>{0, 0, 1, 0, 0, 0, 0, 1});
    const int rotations = file.addAccessor("VEC4", 5126, 2);
    const int scales = file.addPositions({1, 1, 1, 1, 1, -3});
    file.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    auto& node = file.json["nodes"][0] = {{"mesh", 0}, {"translation", {0, 100, 0}}};
    node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"TRANSLATION", translations}, {"ROTATION", rotations}, {"SCALE", scales}};
    const auto mesh = readFile(file).mesh;
    checkBody(mesh, 4);
    CHECK(boxOfFaces(mesh).min().isApprox(Eigen::Vector3d(-1, -1, 99)));
    CHECK(boxOfFaces(mesh).max().isApprox(Eigen::Vector3d(6, 3, 101)));
}

TEST_CASE("The nodes of a glTF file are its groups, and what is left out is noted") {
    GltfFile file;
    addCube(file);
    file.json["meshes"][0]["name"] = "leg";
    file.json["nodes"] = {{{"mesh", 0}},
                          {{"mesh", 0}, {"name", "left\nleg"}, {"translation", {2, 0, 0}}},
                          {{"mesh", 1}, {"translation", {4, 0, 0}}}};
    addCube(file);
    const auto read = readFile(file);
    REQUIRE(read.groups.size() == 2);
    CHECK(read.groups[0].name == "leg");
    CHECK(read.groups[1].name == "left?leg");
    CHECK(read.groups[1].faces.front() == 12);
    CHECK(read.groups[1].faces.back() == 23);
    CHECK(read.notes.empty());

    auto& primitives = file.json["meshes"][0]["primitives"];
    for (const int mode : {0, 1, 2, 3, 7})
        primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"mode", mode}});
    primitives.push_back({{"attributes", json::object()}});
    file.json["nodes"][1]["skin"] = 0;
    const auto odd = readFile(file);
    CHECK(odd.mesh.faceCount() == 36);
    CHECK(odd.notes == "Left out 6 parts without triangles. Skeletons and morph targets are left "
                       "out: the mesh keeps the pose that it has without them.");
    file.json["nodes"][1].erase("skin");
    primitives = {primitives[0], primitives[1]};
    CHECK(readFile(file).notes == "Left out one part without triangles.");
    primitives.erase(1);
    primitives[0]["targets"] = {{{"POSITION", 0}}};
    CHECK_THAT(readFile(file).notes, ContainsSubstring("morph targets"));
}

TEST_CASE("A glTF file may have its buffer in a chunk, in its text or beside it") {
    GltfFile file;
    addCube(file);
    file.json["nodes"] = {{{"mesh", 0}}};
    file.buffer += "x"; // the chunk is padded
    std::filesystem::create_directories(testFolder() / "parts");
    written("parts/the cube.bin", file.buffer);
    const auto whole = readFile(file).mesh;
    for (const auto& text :
         {file.text(), "\xef\xbb\xbf" + file.text(), file.text("parts/the%20cube.bin")}) {
        const auto read = readMesh(written("cube.GLTF", text));
        REQUIRE(read);
        CHECK(read->vertices == whole.vertices);
        CHECK(read->faces == whole.faces);
    }
    SECTION("pictures are neither read nor trusted") {
        file.json["images"] = {{{"uri", "missing.png"}}, {{"bufferView", 99}}, "nonsense"};
        file.json["textures"] = {7};
        CHECK(readFile(file).mesh.faceCount() == 12);
    }
}

TEST_CASE("A glTF file is in metres, unless another unit is named") {
    GltfFile file;
    addCube(file);
    for (const auto& [scale, sentence] :
         {std::pair{1.0, ""},
          {100.0, "The mesh measures 100 x 100 x 100, which its format takes for metres, but no "
                  "instrument has this size: set the unit if it is another."}}) {
        file.json["nodes"] = {{{"mesh", 0}, {"scale", {scale, scale, scale}}}};
        const auto path = written("metres.glb", file.glb());
        const auto read = readMetricMesh(path, std::nullopt);
        REQUIRE(read);
        CHECK(read->mesh.vertices.maxCoeff() == scale);
        CHECK(read->unitSentence == sentence);
        const auto named = readMetricMesh(path, "mm");
        REQUIRE(named);
        CHECK(std::abs(named->mesh.vertices.maxCoeff() - scale / 1000) < 1e-12);
    }
}
