// Tests how the many programs that write meshes spell the same bar.
#include "Geometry/LengthUnit.h"
#include "Geometry/MeshReader.h"
#include "Geometry/MeshRepair.h"
#include "Support/TestFolder.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <sstream>

using namespace idiophone;
using Catch::Matchers::ContainsSubstring;

namespace {

Result<MeshOfFile> read(const std::string& name, const std::string& bytes) {
    const auto path = test::testFolder() / name;
    std::ofstream(path, std::ios::binary) << bytes;
    return readMeshFile(path);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

/// A closed wedge of five corners: two sides are triangles, the bottom is a quadrangle.
const std::string corners[] = {"0 0 0", "0.3 0 0", "0.3 0.05 0", "0 0.05 0", "0.1 0.02 0.04"};
const std::vector<int> faces[] = {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
constexpr double volumeM3 = 0.3 * 0.05 * 0.04 / 3;

std::string obj(const std::string& ofCorner = "", const std::string& between = " ") {
    std::string text;
    for (const auto& corner : corners)
        text += "v " + corner + "\n";
    for (const auto& face : faces) {
        text += "f";
        for (const int corner : face)
            text += (corner == face[2] ? between : " ") + std::to_string(corner + 1) +
                    replaced(ofCorner, "N", std::to_string(corner + 1));
        text += "\n";
    }
    return text;
}

/// Returns the rows of an OFF file; `behind` follows each vertex on its line.
std::string offRows(const std::string& behind = "") {
    std::string text;
    for (const auto& corner : corners)
        text += corner + behind + "\n";
    for (const auto& face : faces) {
        text += std::to_string(face.size());
        for (const int corner : face)
            text += " " + std::to_string(corner);
        text += "\n";
    }
    return text;
}

std::string stl(const std::string& name = "wedge") {
    std::string text = "solid " + name + "\n";
    for (const auto& face : faces)
        for (std::size_t third = 2; third < face.size(); ++third) {
            text += " facet normal 0 0 0\n  outer loop\n";
            for (const int corner : {face[0], face[third - 1], face[third]})
                text += "   vertex " + corners[corner] + "\n";
            text += "  endloop\n endfacet\n";
        }
    return text + "endsolid " + name + "\n";
}

std::string binaryStl(std::uint32_t counted, const std::string& behind = "") {
    std::string bytes(80, ' ');
    const auto append = [&](auto value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    append(counted);
    for (const auto& face : faces)
        for (std::size_t third = 2; third < face.size(); ++third) {
            bytes.append(12, '\0');
            for (const int corner : {face[0], face[third - 1], face[third]}) {
                std::istringstream numbers(corners[corner]);
                for (float number = 0; numbers >> number;)
                    append(number);
            }
            append(std::uint16_t{0});
        }
    return bytes + behind;
}

void checkWedge(const Mesh& mesh) {
    const auto repaired = repairMesh(mesh);
    REQUIRE(repaired);
    CHECK(repaired->mesh.vertexCount() == 5);
    CHECK(repaired->mesh.faceCount() == 6);
    CHECK(isClosed(uniqueEdges(repaired->mesh)));
    CHECK(std::abs(signedVolumeM3(repaired->mesh) - volumeM3) < 1e-5 * volumeM3);
}

void checkWedge(const std::string& name, const std::string& bytes) {
    INFO(name << ":\n" << bytes);
    const auto mesh = read(name, bytes);
    REQUIRE(mesh);
    CHECK(mesh->notes.empty());
    checkWedge(mesh->mesh);
}

} // namespace

TEST_CASE("OBJ faces are read in all spellings, with any line end") {
    for (const auto* ofCorner : {"", "/N", "//N", "/N/N", "//", "/N/"})
        for (const auto* between : {" ", "\t", " \\\n", "\\\n ", " \\ \n  \\\n "})
            for (const auto* lineEnd : {"\n", "\r\n", "\r"}) {
                const auto text = replaced(obj(ofCorner, between), "\n", lineEnd);
                checkWedge("faces.obj", text);
                checkWedge("faces.obj", "\xef\xbb\xbf# \\" + std::string(lineEnd) + text);
                checkWedge("faces.obj", text.substr(0, text.size() - std::strlen(lineEnd)));
            }
    checkWedge("vertex.obj", replaced(obj(), "v 0.3 ", "v 0.3 \\\n"));
    checkWedge("fo.obj", replaced(obj(), "f ", "fo "));
}

TEST_CASE("A backslash in a comment or a name of OBJ continues nothing") {
    checkWedge("names.obj", replaced(obj(), "f ", "# C:\\meshes\\\nusemtl a\\b\\\nf "));
    checkWedge("names.obj", replaced(obj(), "f 1 2 5", "f 1 2 5 # \\"));
}

TEST_CASE("A last line that ends with a backslash ends the OBJ file") {
    checkWedge("backslash.obj", obj() + "usemtl a\\");
    const auto whole = obj();
    checkWedge("backslash.obj", whole.substr(0, whole.size() - 1) + "\\");
}

TEST_CASE("OFF headers are read in all spellings") {
    for (const auto* header :
         {"OFF\n5 5 0\n", "OFF 5 5 0\n", "OFF5 5 8\n", "off\n5 5 8\n", "Off 5 5 8\n", "5 5 8\n",
          "OFF\n\n# a comment\n5 5 8\n", "# first\nOFF\n5 5\n", "OFF\n5\n5\n8\n", "\n OFF\n5 5 8\n",
          "\xef\xbb\xbfOFF\n5 5 8\n", "nOFF\n3\n5 5 8\n", "nOFF 3\n5 5 8\n"})
        for (const auto* lineEnd : {"\n", "\r\n", "\r"})
            checkWedge("header.off", replaced(header + offRows(), "\n", lineEnd));
    for (const auto* kind : {"NOFF", "noff"})
        checkWedge("normals.off", kind + ("\n5 5 8\n" + offRows(" 0 0 1")));
    for (const auto* kind : {"COFF", "coff"})
        checkWedge("colours.off", kind + ("\n5 5 8\n" + offRows(" 255 0 0 255")));
    checkWedge("all.off", "STCNOFF\n5 5 8\n" + offRows(" 0 0 1 0.5 0.5 0.5 1 0 0"));
    checkWedge("short.off", "OFF\n5 5 8\n" + offRows().substr(0, offRows().size() - 1));
    checkWedge("wrapped.off", "OFF\n5 5 8\n" + replaced(offRows(), "4 0 3 2 1", "4 0 3\n2 1"));
}

TEST_CASE("Vertices of 4OFF are divided by their fourth coordinate") {
    const auto mesh = read("four.off", "4OFF\n5 5 8\n" + offRows(" 2"));
    REQUIRE(mesh);
    checkWedge(Mesh{mesh->mesh.vertices * 2, mesh->mesh.faces});
    CHECK_FALSE(read("zero.off", "4OFF\n5 5 8\n" + offRows(" 0")));
}

TEST_CASE("OFF files of other dimensions, and binary ones, are refused as such") {
    CHECK_THAT(read("plane.off", "nOFF 2\n3 1 0\n0 0\n1 0\n0 1\n3 0 1 2\n").error().message,
               ContainsSubstring("do not have three dimensions"));
    CHECK_THAT(read("binary.off", std::string("OFF BINARY\n\0\0\0\5", 15)).error().message,
               ContainsSubstring("binary OFF"));
}

TEST_CASE("Text STL is read in all spellings") {
    const auto whole = stl();
    std::string upper = whole;
    for (char& letter : upper)
        letter = static_cast<char>(std::toupper(letter));
    for (const auto& text :
         {whole, upper, " " + whole, "\n\t" + whole, "\xef\xbb\xbf" + whole,
          replaced(whole, "endsolid", "end solid"), replaced(whole, "endsolid ", "endsolid"),
          replaced(whole, "solid ", "solid"), replaced(whole, "endloop", "end loop"),
          replaced(whole, "endfacet", "end facet"), replaced(whole, "  endloop\n", ""),
          replaced(whole, "solid wedge", "Solid"), whole + "\n\n",
          whole.substr(0, whole.size() - 1), stl("vertex facet solid"), stl("#1"),
          replaced(whole, "facet normal 0 0 0", "facet normal nan nan nan"),
          replaced(whole, "\n", " \t\n"), replaced(whole, "\n", " ")})
        for (const auto* lineEnd : {"\n", "\r\n", "\r"})
            checkWedge("wedge.stl", replaced(text, "\n", lineEnd));
}

TEST_CASE("Text STL without its last line is read with a warning; half a triangle is refused") {
    const auto whole = stl();
    const auto mesh = read("endless.stl", whole.substr(0, whole.find("endsolid")));
    REQUIRE(mesh);
    checkWedge(mesh->mesh);
    CHECK_THAT(mesh->notes, ContainsSubstring("may be missing"));
    for (const auto* last : {"endfacet", "endloop", "vertex 0.1 0.02", "outer"})
        CHECK_THAT(read("half.stl", whole.substr(0, whole.rfind(last))).error().message,
                   ContainsSubstring("it ends inside triangle"));
}

TEST_CASE("Binary STL with a wrong count is read with a warning") {
    for (const std::uint32_t counted : {0U, 3U, 5U}) {
        const auto mesh = read("uncounted.stl", binaryStl(counted));
        REQUIRE(mesh);
        checkWedge(mesh->mesh);
        CHECK_THAT(mesh->notes, ContainsSubstring("counts " + std::to_string(counted)) &&
                                    ContainsSubstring("holds 6"));
    }
    for (const auto& behind : {std::string(17, 'x'), std::string(50, '\xff')}) {
        const auto mesh = read("longer.stl", binaryStl(6, behind));
        REQUIRE(mesh);
        checkWedge(mesh->mesh);
        CHECK_THAT(mesh->notes,
                   ContainsSubstring("Left out " + std::to_string(behind.size()) + " bytes"));
    }
    CHECK_THAT(read("web.stl", "<!DOCTYPE html>" + std::string(200, ' ')).error().message,
               ContainsSubstring("does not begin with \"solid\""));
}

TEST_CASE("Faces and triangle strips of PLY are read, with any line end") {
    std::string vertices, rows;
    for (const auto& corner : corners)
        vertices += corner + "\n";
    for (const auto& face : faces) {
        rows += std::to_string(face.size());
        for (const int corner : face)
            rows += " " + std::to_string(corner);
        rows += "\n";
    }
    const std::string header =
                          "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty "
                          "float y\nproperty float z\n",
                      list = "property list uchar int vertex_indices\nend_header\n";
    for (const auto& text : {header + "element face 5\n" + list + vertices + rows,
                             header + "element tristrips 1\n" + list + vertices +
                                 "20 1 0 2 3 -1 0 1 4 -1 1 2 4 -1 2 3 4 -1 3 0 4\n"})
        for (const auto* lineEnd : {"\n", "\r\n", "\r"}) {
            checkWedge("wedge.ply", replaced(text, "\n", lineEnd));
            checkWedge("wedge.ply", "\xef\xbb\xbf" + replaced(text, "\n", lineEnd));
        }
}

TEST_CASE("Concave faces of OBJ, OFF and PLY are filled inside their outline") {
    const std::string v[] = {"0 0 0", "5 0 0", "5 1 0", "1 1 0", "1 4 0", "0 4 0"};
    for (int first = 0; first < 6; ++first) {
        std::string objText, rows, obj = "f", indices = "6";
        for (int k = 0; k < 6; ++k) {
            objText += "v " + v[k] + "\n";
            rows += v[k] + "\n";
            obj += " " + std::to_string((first + k) % 6 + 1);
            indices += " " + std::to_string((first + k) % 6);
        }
        for (const auto& [name, bytes] :
             {std::pair<std::string, std::string>{"l.obj", objText + obj + "\n"},
              {"before.obj", obj + "\n" + objText},
              {"l.off", "OFF 6 1 0\n" + rows + indices + "\n"},
              {"l.ply", "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty "
                        "float y\nproperty float z\nelement face 1\nproperty list uchar int "
                        "vertex_indices\nend_header\n" +
                            rows + indices + "\n"}}) {
            INFO(name << " from " << first);
            const auto mesh = read(name, bytes);
            REQUIRE(mesh);
            CHECK(std::abs(faceAreas(mesh->mesh).sum() - 8) < 1e-12);
            CHECK(mesh->notes.empty());
        }
    }
}

TEST_CASE("A face that crosses itself is read with a warning") {
    const auto mesh = read("bow.obj", "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n");
    REQUIRE(mesh);
    CHECK_THAT(mesh->notes, ContainsSubstring("crosses itself"));
}

TEST_CASE("Vertices without a face change neither the unit nor the repair") {
    for (const auto* stray : {"v 30 0 0\n", "v 500000 0 0\n", "v 1e12 0 0\n", "v nan 0 0\n"}) {
        INFO(stray);
        const auto behind = read("stray.obj", obj() + stray);
        REQUIRE(behind);
        CHECK(guessLengthUnit(behind->mesh).unit.symbol == "m");
        checkWedge(behind->mesh);
        CHECK(repairMesh(behind->mesh)->report.unreferencedVertices == 1);
    }
}

TEST_CASE("A mesh far from the origin is moved there before anything is rounded") {
    for (const double far : {1000.0, 100000.0, 4000000.0}) {
        std::ostringstream text;
        text << std::setprecision(17);
        for (const auto& corner : corners) {
            std::istringstream numbers(corner);
            text << "v";
            for (double number = 0; numbers >> number;)
                text << " " << far + number;
            text << "\n";
        }
        text << obj().substr(obj().find('f'));
        const auto mesh = read("far.obj", text.str());
        REQUIRE(mesh);
        CHECK(mesh->mesh.vertices.cwiseAbs().maxCoeff() < 0.2);
        CHECK_THAT(mesh->notes, ContainsSubstring("Moved the mesh to the origin"));
        checkWedge(mesh->mesh);
    }
    const auto near = read("near.obj", replaced(obj(), "v 0", "v 20"));
    REQUIRE(near);
    CHECK(near->mesh.vertices.maxCoeff() > 20);
}

TEST_CASE("The largest numbers are moved or refused") {
    for (const auto* far : {"1e12", "1.5e308"}) {
        const auto mesh = read("point.obj", std::string("v ") + far + " 0 0\nf 1 1 1\n");
        REQUIRE(mesh);
        CHECK(mesh->mesh.vertices.isZero());
    }
    for (const auto* wide : {"1e155", "1e200", "1.5e308"})
        CHECK_THAT(
            read("wide.obj", replaced("v 0 0 0\nv W 0 0\nv 0 W 0\nv 1 1 0\nf 1 2 4 3\n", "W", wide))
                .error()
                .message,
            ContainsSubstring("more than a million units"));
}

TEST_CASE("Rounded coordinates of a mesh far from the origin are reported") {
    const auto mesh =
        read("rounded.obj", "v 100000 0 0\nv 100000.125 0 0\nv 100000 0.25 0\nf 1 2 3\n");
    REQUIRE(mesh);
    CHECK_THAT(mesh->notes, ContainsSubstring("are rounded to 0.01"));
}
