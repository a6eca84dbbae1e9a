// glTF splits the vertices of edges and corners, where normals or textures meet.
#include "Analysis/ModalAnalysis.h"

#include "Geometry/MeshReader.h"
#include "Geometry/MeshWriter.h"
#include "Support/GltfFile.h"
#include "Support/TestFolder.h"
#include "TestMaterials.h"

#include <catch2/catch_test_macros.hpp>
#include <fstream>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// A cube whose six faces have vertices of their own.
Mesh splitCube(double side) {
    Mesh mesh{Eigen::MatrixXd(24, 3), Eigen::MatrixXi(12, 3)};
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2, isFar = face % 2, first = 4 * face;
        for (int corner = 0; corner < 4; ++corner) {
            const int row = first + corner;
            mesh.vertices(row, axis) = side * isFar;
            mesh.vertices(row, (axis + 2 - isFar) % 3) = side * (corner % 2);
            mesh.vertices(row, (axis + 1 + isFar) % 3) = side * (corner / 2);
        }
        mesh.faces.row(2 * face) << first, first + 1, first + 3;
        mesh.faces.row(2 * face + 1) << first, first + 3, first + 2;
    }
    return mesh;
}

/// Returns the mesh with one vertex for each place, in the order of their first use.
Mesh united(const Mesh& mesh) {
    Mesh result{Eigen::MatrixXd(0, 3), mesh.faces};
    std::vector<int> number;
    for (const auto& place : mesh.vertices.rowwise()) {
        int vertex = 0;
        while (vertex < result.vertexCount() && result.vertices.row(vertex) != place)
            ++vertex;
        if (vertex == result.vertexCount()) {
            result.vertices.conservativeResize(vertex + 1, 3);
            result.vertices.row(vertex) = place;
        }
        number.push_back(vertex);
    }
    for (int& corner : result.faces.reshaped())
        corner = number[static_cast<std::size_t>(corner)];
    return result;
}

std::vector<double> eigenvaluesOf(const std::filesystem::path& file, int vertices) {
    const auto mesh = readMesh(file);
    REQUIRE(mesh);
    CHECK(mesh->vertexCount() == vertices);
    AnalysisSettings settings;
    settings.material = referenceWood();
    settings.elementBudget = 300;
    const auto object = analyse(*mesh, settings);
    REQUIRE(object);
    CHECK(object->method == "fem");
    CHECK(object->modeCount() > 5);
    return object->eigenvalues;
}

} // namespace

TEST_CASE("A glTF cube of 24 vertices has the modes of an OBJ cube of eight") {
    const auto split = splitCube(0.125);
    std::ofstream(testFolder() / "cube.glb", std::ios::binary) << glbOf(split);
    REQUIRE(writeMesh(united(split), testFolder() / "cube.obj"));
    CHECK(eigenvaluesOf(testFolder() / "cube.glb", 24) ==
          eigenvaluesOf(testFolder() / "cube.obj", 8));
}
