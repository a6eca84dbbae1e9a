// Meshes from glTF files: what is refused, and in which words.
#include "Geometry/MeshReader.h"
#include "Gltf/GltfDocument.h"

#include "Support/GltfFile.h"
#include "Support/TestFolder.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <fstream>
#include <functional>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;
using nlohmann::json;

namespace {

std::string errorOf(const std::string& bytes) {
    const auto path = testFolder() / "bad.glb";
    std::ofstream(path, std::ios::binary) << bytes;
    const auto read = readMesh(path);
    return read ? "" : read.error().message;
}

GltfFile triangle() {
    GltfFile file;
    const int positions = file.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    file.addMesh(positions, file.addIndices({0, 1, 2}));
    file.json["nodes"] = {{{"mesh", 0}}};
    return file;
}

struct Fault {
    std::function<void(GltfFile&)> change;
    const char* sentence;
};

} // namespace

TEST_CASE("Every fault of a glTF file has its sentence") {
    REQUIRE(errorOf(triangle().glb()).empty());
    const auto primitive = [](GltfFile& file) -> json& {
        return file.json["meshes"][0]["primitives"][0];
    };
    const Fault faults[]{
        {[](auto& f) { f.json["asset"]["version"] = "1.0"; }, "its version of glTF is not 2"},
        {[](auto& f) { f.json.erase("asset"); }, "it has no \"asset\""},
        {[](auto& f) { f.json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
         "it requires the extension 'KHR_draco_mesh_compression'"},
        {[](auto& f) { f.json["extensionsRequired"] = {"EXT_meshopt_compression"}; },
         "it requires the extension 'EXT_meshopt_compression'"},
        {[](auto& f) { f.json["nodes"] = json::array(); }, "its scene shows no triangles"},
        {[](auto& f) {
             f.json["scenes"] = {{{"nodes", json::array()}}};
         },
         "its scene shows no triangles"},
        {[&](auto& f) { primitive(f)["mode"] = 1; }, "its scene shows no triangles"},
        {[](auto& f) {
             f.json["scenes"] = {{{"nodes", {0}}}};
             f.json["nodes"][0]["children"] = {0};
         },
         "node 0 is placed twice, or is its own ancestor"},
        {[](auto& f) { f.json["nodes"][0]["children"] = {9}; }, "node 9 does not exist"},
        {[](auto& f) { f.json["nodes"][0]["mesh"] = 3; }, "mesh 3 does not exist"},
        {[&](auto& f) { primitive(f)["attributes"]["POSITION"] = 8; }, "accessor 8 does not exist"},
        {[&](auto& f) { primitive(f)["attributes"]["POSITION"] = 1; },
         "accessor 1 has another type than its use"},
        {[](auto& f) { f.json["accessors"][0]["componentType"] = 5130; },
         "accessor 0 has another type than its use"},
        {[&](auto& f) {
             primitive(f)["indices"] = f.addIndices({0, 1, 65535});
         },
         "a face names a vertex that does not exist (there are 3 vertices)"},
        {[](auto& f) { f.json["accessors"][0]["count"] = 4; },
         "one of its accessors lies outside its buffer"},
        {[](auto& f) { f.json["bufferViews"][0]["byteLength"] = 1000; },
         "one of its accessors lies outside its buffer"},
        {[](auto& f) { f.json["bufferViews"][0]["byteOffset"] = 1ull << 63; },
         "one of its accessors lies outside its buffer"},
        {[](auto& f) { f.json["bufferViews"][0]["buffer"] = 5; },
         "one of its accessors lies outside its buffer"},
        {[&](auto& f) {
             f.json["accessors"][0]["sparse"] = {
                 {"count", 1},
                 {"indices",
                  {{"bufferView", f.addView(std::vector<std::uint8_t>{3})},
                   {"componentType", 5121}}},
                 {"values", {{"bufferView", f.addView(std::vector<float>{1, 1, 1})}}}};
         },
         "a sparse accessor names an element that does not exist"},
        {[](auto& f) {
             f.json["nodes"][0]["scale"] = {1e300, 1, 1};
         }, // infinite
         "its faces reach over more than a million units"},
        {[](auto& f) {
             f.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
                 {"TRANSLATION", 0}, {"SCALE", f.addPositions({1, 1, 1})}};
         },
         "a node's instances have attributes of different lengths"},
        {[](auto& f) { f.json["meshes"] = {7}; }, "it is malformed"},
        {[](auto& f) { f.json["accessors"][0].erase("count"); },
         "it is malformed: 'count' property is missing"},
    };
    for (const auto& [change, sentence] : faults) {
        INFO(sentence);
        auto file = triangle();
        change(file);
        const auto error = errorOf(file.glb());
        CHECK_THAT(error, ContainsSubstring(sentence));
        CHECK_THAT(error, ContainsSubstring("bad.glb\" cannot be used: "));
    }
}

TEST_CASE("A damaged container of glTF is refused") {
    const auto whole = triangle().glb();
    for (const std::size_t size : {4u, 11u, 19u, 60u, static_cast<unsigned>(whole.size()) - 1})
        CHECK_THAT(errorOf(whole.substr(0, size)), ContainsSubstring("it is truncated"));
    // tinygltf would read beyond the end of a chunk that is up to eight bytes too long.
    auto longer = whole;
    const auto chunk = longer.rfind("BIN") - 4;
    longer.replace(chunk, 4, GltfFile::count(triangle().buffer.size() + 8));
    CHECK_THAT(errorOf(longer), ContainsSubstring("it is truncated"));
    const auto jsonOnly = whole.substr(0, chunk).replace(8, 4, GltfFile::count(chunk));
    CHECK_THAT(errorOf(jsonOnly), ContainsSubstring("'uri' is missing"));
    CHECK_THAT(errorOf("{\"asset\": {"), ContainsSubstring("it is not the JSON of a glTF file"));
    CHECK_THAT(errorOf(std::string(100000, '[')), ContainsSubstring("not the JSON"));
    CHECK_THAT(errorOf("[]"), ContainsSubstring("not the JSON"));
}

TEST_CASE("Buffers of glTF are read from the folder of the file only") {
    const auto file = triangle();
    for (const auto* name : {"../outside.bin", "/etc/passwd", "a/../../b.bin"}) {
        INFO(name);
        CHECK_THAT(errorOf(file.text(name)),
                   ContainsSubstring("cannot be read: it is not in the folder of the file"));
    }
    CHECK_THAT(errorOf(file.text("missing.bin")), ContainsSubstring("its buffer 'missing.bin'"));
    std::ofstream(testFolder() / "short.bin") << "short";
    CHECK_THAT(errorOf(file.text("short.bin")), ContainsSubstring("File size mismatch"));
    const auto alone = GltfDocument::parse(file.text("short.bin"));
    REQUIRE_FALSE(alone);
    CHECK_THAT(alone.error().message, ContainsSubstring("only the bytes of this one are given"));
}

TEST_CASE("A small glTF file cannot ask for endless triangles or work") {
    const char* sentence = "it repeats its meshes too often";
    GltfFile file;
    const int positions = file.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const auto longStrip = [&](std::uint16_t third) {
        std::vector<std::uint16_t> strip(60000, 1);
        strip[2] = third;
        return file.addIndices(strip);
    };
    file.addMesh(positions, longStrip(2), 6);
    SECTION("by nodes") {
        for (int node = 0; node < 200; ++node)
            file.json["nodes"].push_back({{"mesh", 0}});
        CHECK_THAT(errorOf(file.glb()), ContainsSubstring(sentence));
    }
    SECTION("by instances") {
        file.addView(std::vector<std::int8_t>(4000));
        file.json["nodes"] = {{{"mesh", 0}}};
        file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
            {"TRANSLATION", file.addAccessor("VEC3", 5120, 1000)}};
        CHECK_THAT(errorOf(file.glb()), ContainsSubstring(sentence));
    }
    SECTION("by primitives without an area") {
        file.addMesh(positions, longStrip(1), 5);
        auto& primitives = file.json["meshes"][1]["primitives"];
        for (int i = 0; i < 200; ++i)
            primitives.push_back(primitives[0]);
        file.json["nodes"] = {{{"mesh", 1}}};
        CHECK_THAT(errorOf(file.glb()), ContainsSubstring(sentence));
    }
    SECTION("by an accessor without a buffer") {
        file.json["accessors"].push_back(
            {{"type", "VEC3"}, {"componentType", 5126}, {"count", 1ull << 40}});
        file.addMesh(static_cast<int>(file.json["accessors"].size()) - 1);
        file.json["nodes"] = {{{"mesh", 1}}};
        CHECK_THAT(errorOf(file.glb()), ContainsSubstring(sentence));
    }
}
