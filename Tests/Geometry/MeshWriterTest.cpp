#include "Geometry/MeshWriter.h"
#include "Geometry/ColourMap.h"
#include "Geometry/MeshReader.h"
#include "Geometry/ParametricMesh.h"
#include "Support/GeneratedMeshes.h"
#include "Support/TestFolder.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace idiophone;
using namespace idiophone::test;

namespace {

std::filesystem::path scratch(const char* name) {
    return test::testFolder() / name;
}

} // namespace

TEST_CASE("A mesh with colours and values is read back bit for bit") {
    const Mesh mesh = gridPlateMesh(0.3, 0.1, 3, 2);
    VertexFigures figures{.name = "brightness_hz", .values = {}, .colours = {}};
    for (Eigen::Index i = 0; i < mesh.vertexCount(); ++i) {
        figures.values.push_back(1.0 / 3 + static_cast<double>(i));
        figures.colours.push_back({static_cast<std::uint8_t>(i), 7, 255});
    }
    const auto file = scratch("coloured.ply");
    REQUIRE(writeColouredMesh(mesh, figures, file));
    const auto back = readMesh(file);
    REQUIRE(back);
    CHECK(back->vertices == mesh.vertices);
    CHECK(back->faces == mesh.faces);
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    CHECK(text.str().find("property uchar red\nproperty uchar green\nproperty uchar blue\n"
                          "property double brightness_hz\n") != std::string::npos);
    CHECK(text.str().find(" 2 7 255 2.3333333333333335\n") != std::string::npos);
    std::filesystem::remove(file);
}

TEST_CASE("Colours are written to PLY files only, and errors name the file") {
    const Mesh mesh = gridPlateMesh(0.3, 0.1, 1, 1);
    const VertexFigures figures{
        .name = "x", .values = std::vector<double>(4), .colours = std::vector(4, viridis(0))};
    const auto wrong = writeColouredMesh(mesh, figures, scratch("map.obj"));
    REQUIRE_FALSE(wrong);
    CHECK(wrong.error().message.find(scratch("map.obj").string()) != std::string::npos);
    const auto nowhere = writeColouredMesh(mesh, figures, scratch("no/such/folder.ply"));
    REQUIRE_FALSE(nowhere);
    CHECK(nowhere.error().message.find(scratch("no/such/folder.ply").string()) !=
          std::string::npos);
}

TEST_CASE("File extensions are recognised in upper and lower case") {
    const Mesh mesh = gridPlateMesh(0.3, 0.1, 1, 1);
    for (const char* name : {"out.PLY", "out.Obj"}) {
        const auto file = scratch(name);
        REQUIRE(writeMesh(mesh, file));
        const auto back = readMesh(file, 1);
        REQUIRE(back);
        CHECK(back->faces == mesh.faces);
        std::filesystem::remove(file);
    }
    const VertexFigures figures{
        .name = "x", .values = std::vector<double>(4), .colours = std::vector(4, viridis(0))};
    CHECK(writeColouredMesh(mesh, figures, scratch("map.Ply")));
}

TEST_CASE("Viridis goes from violet over green to yellow with increasing lightness") {
    using Colour = std::array<std::uint8_t, 3>;
    CHECK(viridis(0) == Colour{68, 1, 84});
    CHECK(viridis(-3) == viridis(0));
    CHECK(viridis(1) == Colour{253, 231, 37});
    CHECK(viridis(7) == viridis(1));
    CHECK(viridis(std::nan("")) == viridis(0));
    const auto lightness = [](const Colour& c) {
        return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    };
    for (int i = 0; i < 50; ++i)
        CHECK(lightness(viridis((i + 1) / 50.0)) > lightness(viridis(i / 50.0)));
}
