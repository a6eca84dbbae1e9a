#include "Geometry/MeshReader.h"

#include "Geometry/MeshWriter.h"
#include "Geometry/ParametricMesh.h"
#include "Support/GltfFile.h"
#include "Support/TestFolder.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cstring>
#include <fstream>
#include <random>

using namespace idiophone;
using Catch::Matchers::ContainsSubstring;

namespace {

std::filesystem::path fileOf(const std::string& name, const std::string& bytes) {
    const auto path = test::testFolder() / name;
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

std::string errorOf(const std::string& name, const std::string& bytes) {
    const auto mesh = readMesh(fileOf(name, bytes));
    return mesh ? "" : mesh.error().message;
}

template <class T>
void append(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string binaryStl(const Mesh& mesh, const std::string& header = "binary") {
    std::string bytes = header;
    bytes.resize(80);
    append(bytes, static_cast<std::uint32_t>(mesh.faceCount()));
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        for (int i = 0; i < 3; ++i)
            append(bytes, 0.0f);
        for (int corner = 0; corner < 3; ++corner)
            for (int axis = 0; axis < 3; ++axis)
                append(bytes, static_cast<float>(mesh.vertices(mesh.faces(face, corner), axis)));
        append(bytes, std::uint16_t{0});
    }
    return bytes;
}

std::string binaryPly(const Mesh& mesh) {
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                        std::to_string(mesh.vertexCount()) +
                        "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar "
                        "red\nelement face " +
                        std::to_string(mesh.faceCount()) +
                        "\nproperty list uchar int vertex_index\nend_header\n";
    for (Eigen::Index v = 0; v < mesh.vertexCount(); ++v) {
        for (int axis = 0; axis < 3; ++axis)
            append(bytes, static_cast<float>(mesh.vertices(v, axis)));
        bytes += '\x7f';
    }
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        bytes += '\3';
        for (int corner = 0; corner < 3; ++corner)
            append(bytes, std::int32_t{mesh.faces(face, corner)});
    }
    return bytes;
}

const std::string triangleObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

} // namespace

TEST_CASE("A mesh written as OBJ or PLY is read back bit for bit") {
    const auto sphere = icosphereMesh(0.1234567, 2);
    for (const char* name : {"round.obj", "round.ply"}) {
        const auto path = test::testFolder() / name;
        REQUIRE(writeMesh(sphere, path));
        const auto read = readMesh(path);
        REQUIRE(read);
        CHECK(read->vertices == sphere.vertices);
        CHECK(read->faces == sphere.faces);
    }
    CHECK_FALSE(writeMesh(sphere, "sphere.step"));
    CHECK_FALSE(writeMesh(sphere, "/no/such/folder/sphere.obj"));
}

TEST_CASE("Binary STL, text STL, binary PLY and OFF give the same triangles") {
    const auto box = boxMesh({1, 2, 3}, {1, 1, 1});
    std::string off = "OFF\n# a comment\n8 12 0\n", stl = "solid a box\n";
    for (const auto& v : box.vertices.rowwise())
        off +=
            std::to_string(v(0)) + " " + std::to_string(v(1)) + " " + std::to_string(v(2)) + "\n";
    for (const auto& f : box.faces.rowwise()) {
        off += "3 " + std::to_string(f(0)) + " " + std::to_string(f(1)) + " " +
               std::to_string(f(2)) + " 0.5 0.5 0.5\n";
        stl += "facet normal 0 0 0\nouter loop\n";
        for (const int c : f)
            stl += "vertex " + std::to_string(box.vertices(c, 0)) + " " +
                   std::to_string(box.vertices(c, 1)) + " " + std::to_string(box.vertices(c, 2)) +
                   "\n";
        stl += "endloop\nendfacet\n";
    }
    stl += "endsolid a box\n";
    const std::pair<std::string, std::string> files[] = {{"box.off", off},
                                                         {"box.stl", stl},
                                                         {"binary.STL", binaryStl(box)},
                                                         {"solid.stl", binaryStl(box, "solid")},
                                                         {"box.ply", binaryPly(box)}};
    for (const auto& [name, bytes] : files) {
        INFO(name);
        const auto read = readMesh(fileOf(name, bytes));
        REQUIRE(read);
        CHECK(read->faceCount() == 12);
        CHECK(std::abs(signedVolumeM3(*read) - 6) < 1e-6);
    }
}

TEST_CASE("A big-endian PLY with other elements and properties is read") {
    std::string bytes = "ply\r\nformat binary_big_endian 1.0\r\ncomment x\r\nelement camera 2\r\n"
                        "property list uchar short knobs\r\nelement vertex 3\r\nproperty double "
                        "z\r\nproperty short x\r\nproperty short y\r\nelement face 1\r\n"
                        "property list uint ushort vertex_indices\r\nend_header\r\n";
    bytes += std::string("\x01\x00\x07\x00", 4);
    for (const char* xy : {"\0\0\0\0", "\0\1\0\0", "\0\0\0\1"}) {
        bytes += std::string("\x40\x00\0\0\0\0\0\0", 8); // 2.0
        bytes += std::string(xy, 4);
    }
    bytes += std::string("\0\0\0\3\0\0\0\1\0\2", 10);
    const auto read = readMesh(fileOf("big.ply", bytes));
    REQUIRE(read);
    CHECK(read->vertices.row(1) == Eigen::RowVector3d(1, 0, 2));
    CHECK(read->faces.row(0) == Eigen::RowVector3i(0, 1, 2));
}

TEST_CASE("Polygons become triangles, and OBJ's negative indices and slashes are read") {
    const auto read = readMesh(fileOf("quad.obj", "o thing\nv 0 0 0 # comment\nv 1 0 0\nv 1 1 0\n"
                                                  "v 0 1 0\nvt 0 0\nf 1/1 2/1 3/1 4/1\n"
                                                  "f -4//2 -3//2 -2//2\n"));
    REQUIRE(read);
    CHECK(read->faceCount() == 3);
    CHECK(read->faces.row(2) == Eigen::RowVector3i(0, 1, 2));
}

TEST_CASE("The unit scales the mesh to metres") {
    const auto path = fileOf("unit.obj", triangleObj + "f 1 2 3\n");
    CHECK(readMesh(path, 0.001)->vertices.maxCoeff() == 0.001);
    CHECK_FALSE(readMesh(path, 0));
    CHECK_FALSE(readMesh(path, std::numeric_limits<double>::quiet_NaN()));
}

TEST_CASE("Each fault of a mesh file gives one sentence with the file's name") {
    const auto [name, bytes, fault] = GENERATE(table<std::string, std::string, std::string>({
        {"empty.obj", "", "is empty"},
        {"empty.ply", "", "is empty"},
        {"faceless.obj", triangleObj, "has no faces"},
        {"nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "vertex 0 is not a finite number"},
        {"inf.obj", "v 0 0 0\nv inf 0 0\nv 0 1 0\nf 1 2 3\n", "vertex 1 is not a finite number"},
        {"wide.obj", "v 0 0 0\nv 1e7 0 0\nv 0 1 0\nf 1 2 3\n", "more than a million units"},
        {"range.obj", triangleObj + "f 1 2 4\n", "names a vertex that does not exist"},
        {"zero.obj", triangleObj + "f 0 1 2\n", "line 4 is not a face"},
        {"minus.obj", triangleObj + "f -9 1 2\n", "names a vertex that does not exist"},
        {"word.obj", "v 0 zero 0\n", "line 1 is not a vertex"},
        {"huge.obj", triangleObj + "f 1 2 99999999999999999999\n", "line 4 is not a face"},
        {"mesh.step", "ISO-10303", "extension is none of"},
        {"noext", triangleObj, "extension is none of"},
        {"magic.off", "PFF\n", "does not begin with \"OFF\""},
        {"comment.off", "OFF\n#", "does not count vertices and faces"},
        {"counts.off", "OFF\n2000000000 2000000000 0\n0 0 0\n", "more than the file can hold"},
        {"minus.off", "OFF\n-1 2 0\n", "does not count vertices and faces"},
        {"short.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n", "ends after 2 of 4"},
        {"valence.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n1000000000 0 1\n", "face 0 is malformed"},
        {"magic.ply", "plx\n", "does not begin with \"ply\""},
        {"header.ply", "ply\nformat ascii 1.0\n", "header does not end"},
        {"format.ply", "ply\nformat ebcdic 1.0\nend_header\n", "format that PLY does not have"},
        {"name.ply", "ply\nformat ascii 1.0\nelement ver\x01tex 9999\nproperty int x\nend_header\n",
         "9999 of element 'ver?tex', more"},
        {"property.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty quad x\nend_header\n",
         "property that cannot be understood"},
        {"count.ply",
         "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000000\nproperty float "
         "x\nend_header\n",
         "more than the file can hold"},
        {"minus.ply", "ply\nformat ascii 1.0\nelement vertex -5\nend_header\n", "valid count"},
        {"nothing.ply", "ply\nformat ascii 1.0\nelement vertex 9000000000000000000\nend_header\n",
         "no faces"},
        {"short.stl", "sol", "too short"},
        {"text.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n",
         "it ends inside triangle 0"},
        {"bad.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 a\n", "three numbers"},
        {"long.stl", "solid " + std::string(100000, 'x'), "has no faces"},
    }));
    INFO(name);
    const auto error = errorOf(name, bytes);
    const auto path = (test::testFolder() / name).string();
    CHECK_THAT(error, ContainsSubstring(fault) && ContainsSubstring("\"" + path + "\""));
    CHECK(error.back() == '.');
    CHECK(error.find('\n') == std::string::npos);
}

TEST_CASE("A missing file or a folder gives a one-sentence error") {
    CHECK_THAT(readMesh("/no/such/bar.obj").error().message,
               ContainsSubstring("\"/no/such/bar.obj\""));
    CHECK_FALSE(readMesh(test::testFolder()));
    std::filesystem::create_directories(test::testFolder() / "folder.obj");
    CHECK_FALSE(readMesh(test::testFolder() / "folder.obj"));
}

TEST_CASE("A truncated binary file is refused") {
    const auto sphere = icosphereMesh(1, 0);
    const auto stl = binaryStl(sphere), ply = binaryPly(sphere);
    for (std::size_t size = 0; size < stl.size(); size += 37)
        REQUIRE_FALSE(readMesh(fileOf("cut.stl", stl.substr(0, size))));
    for (std::size_t size = 0; size < ply.size(); size += 11)
        REQUIRE_FALSE(readMesh(fileOf("cut.ply", ply.substr(0, size))));
    CHECK_THAT(errorOf("cut.stl", stl.substr(0, 500)), ContainsSubstring("truncated"));
}

TEST_CASE("An OBJ file cut inside its last face is refused; a missing final newline is allowed") {
    const std::string before = triangleObj + "v 1 1 0\nvt 0 0\nf 1/1 2/1 3/1\n";
    for (const char* rest :
         {"f", "f 2/1", "f 2/1 3", "f 2/1 3/1 4", "f 2/1 3/1 4/", "f 2/1 3/1 # x"}) {
        INFO(rest);
        CHECK_THAT(errorOf("cut.obj", before + rest), ContainsSubstring("truncated: line 7"));
    }
    for (const char* rest : {"f 2/1 3/1 4/1", "f 2 3 4", "f 2//1 3//1 4//1", "f 2/1 3/1 4/1 # x",
                             "o x", "f 2/1 3/1\nf 2/1 3/1 4\n"}) {
        INFO(rest);
        CHECK(readMesh(fileOf("whole.obj", before + rest)));
    }
}

TEST_CASE("Files with random changed bytes never crash the reader") {
    const auto sphere = icosphereMesh(1, 0);
    const auto obj = test::testFolder() / "fuzz-source.obj";
    REQUIRE(writeMesh(sphere, obj));
    std::ifstream stream(obj, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    std::mt19937 random(1);
    for (const auto& [name, source] : {std::pair<std::string, std::string>{"fuzz.obj", text},
                                       {"fuzz.ply", binaryPly(sphere)},
                                       {"fuzz.stl", binaryStl(sphere)},
                                       {"fuzz.glb", test::glbOf(sphere)}})
        for (int round = 0; round < 300; ++round) {
            auto bytes = source;
            for (unsigned change = 0; change <= random() % 8; ++change)
                bytes[random() % bytes.size()] = static_cast<char>(random());
            if (const auto mesh = readMesh(fileOf(name, bytes))) {
                REQUIRE(mesh->vertices.allFinite());
                REQUIRE(mesh->faces.minCoeff() >= 0);
                REQUIRE(mesh->faces.maxCoeff() < mesh->vertexCount());
            }
        }
}

TEST_CASE("A soup of a million triangles is read completely") {
    std::mt19937 random(2);
    std::string bytes(80, ' ');
    append(bytes, std::uint32_t{1000000});
    for (int face = 0; face < 1000000; ++face) {
        for (int i = 0; i < 12; ++i)
            append(bytes, static_cast<float>(random() % 10000) * 1e-4f);
        append(bytes, std::uint16_t{0});
    }
    const auto path = fileOf("soup.stl", bytes);
    const auto mesh = readMesh(path);
    std::filesystem::remove(path);
    REQUIRE(mesh);
    CHECK(mesh->faceCount() == 1000000);
}
