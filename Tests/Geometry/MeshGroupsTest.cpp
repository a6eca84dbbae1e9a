// Tests of the named groups that mesh files have.
#include "Geometry/MeshReader.h"

#include "Support/TestFolder.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <fstream>

using namespace idiophone;
using Catch::Matchers::ContainsSubstring;

namespace {

std::vector<MeshGroup> groupsOf(const std::string& name, const std::string& bytes) {
    const auto path = test::testFolder() / name;
    std::ofstream(path, std::ios::binary) << bytes;
    const auto read = readMeshFile(path);
    REQUIRE(read);
    return read->groups;
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

} // namespace

TEST_CASE("Groups and objects of an OBJ file name the triangles of their polygons") {
    const auto groups = groupsOf("groups.obj", square + "o the whole\nf 1 2 3\n"
                                                        "g feet rim\nf 1 2 3 4\n"
                                                        "g\nf 2 3 4\ng empty\ng feet\r\nf 1 3 4\n");
    CHECK(groups == std::vector<MeshGroup>{{.name = "the whole", .faces = {0, 1, 2, 3, 4}},
                                           {.name = "feet", .faces = {1, 2, 4}},
                                           {.name = "rim", .faces = {1, 2}}});
}

TEST_CASE("A name counts once for a face, and what is no polygon is in no group") {
    const auto groups =
        groupsOf("twice.obj", square + "o a\ng a a\nf 1 2\nf 1 2 3\no\ng \x1b[2J\nf 2 3 4\n");
    CHECK(groups ==
          std::vector<MeshGroup>{{.name = "a", .faces = {0}}, {.name = "?[2J", .faces = {1}}});
    CHECK(groupsOf("none.obj", square + "f 1 2 3\n").empty());
}

TEST_CASE("The solids of a text STL are its groups") {
    const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                              "vertex 0 1 0\nendloop\nendfacet\n";
    const auto groups =
        groupsOf("solids.stl", "solid left foot\n" + facet + facet + "endsolid left foot\nsolid\n" +
                                   facet + "endsolid\nsolid right\n" + facet + "endsolid right\n");
    CHECK(groups == std::vector<MeshGroup>{{.name = "left foot", .faces = {0, 1}},
                                           {.name = "right", .faces = {3}}});
}

TEST_CASE("A group is found by its name, or the error lists the groups") {
    const std::vector<MeshGroup> groups{{.name = "feet", .faces = {0}},
                                        {.name = "rim", .faces = {1}}};
    CHECK((*findGroup(groups, "rim"))->faces == std::vector{1});
    CHECK(findGroup(groups, "hat").error().message ==
          "There is no group 'hat' in the mesh; its groups are 'feet', 'rim'.");
    CHECK(findGroup({}, "hat").error().message ==
          "There is no group 'hat' in the mesh; its faces have no names.");
    CHECK_THAT(
        findGroup(std::vector<MeshGroup>(30, {.name = "x", .faces = {0}}), "y").error().message,
        ContainsSubstring("'x' and 18 more."));
}

TEST_CASE("A million groups are read, and only the first thousand keep their names") {
    constexpr int count = 1'000'000;
    std::string bytes = square;
    for (int group = 0; group < count; ++group)
        bytes += "g " + std::to_string(group) + "\nf 1 2 3\n";
    const auto groups = groupsOf("million.obj", bytes);
    REQUIRE(groups.size() == maximumMeshGroups);
    CHECK(groups.back() == MeshGroup{.name = "999", .faces = {999}});
    std::string line = square + "g";
    for (int group = 0; group < 1000; ++group)
        line += " n" + std::to_string(group);
    line += '\n';
    for (int face = 0; face < 1000; ++face)
        line += "f 1 2 3\n";
    CHECK(groupsOf("line.obj", line).size() < 10);
}
