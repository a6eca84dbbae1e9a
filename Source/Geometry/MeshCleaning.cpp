#include "Geometry/MeshCleaning.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace idiophone {
namespace {

bool isDegenerate(const Mesh& mesh, const Eigen::RowVector3i& face) {
    if (face(0) == face(1) || face(1) == face(2) || face(2) == face(0))
        return true;
    const Eigen::RowVector3d u = mesh.vertices.row(face(1)) - mesh.vertices.row(face(0));
    const Eigen::RowVector3d v = mesh.vertices.row(face(2)) - mesh.vertices.row(face(0));
    const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
    return u.cross(v).norm() <= 1e-10 * longest;
}

void keepRows(Eigen::MatrixXi& faces, const std::vector<char>& keep) {
    Eigen::Index kept = 0;
    for (Eigen::Index face = 0; face < faces.rows(); ++face)
        if (keep[face])
            faces.row(kept++) = faces.row(face).eval();
    faces.conservativeResize(kept, Eigen::NoChange);
}

} // namespace

void renumberVertices(Mesh& mesh, int count, const std::vector<int>& newNumber) {
    mesh.vertices.conservativeResize(count, Eigen::NoChange);
    mesh.faces = mesh.faces.unaryExpr([&](int vertex) { return newNumber[vertex]; }).eval();
}

int dropDegenerateFaces(Mesh& mesh) {
    std::vector<char> keep(mesh.faceCount());
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        keep[face] = !isDegenerate(mesh, mesh.faces.row(face));
    keepRows(mesh.faces, keep);
    return static_cast<int>(std::ranges::count(keep, 0));
}

int dropDuplicateFaces(Mesh& mesh) {
    std::vector<std::array<int, 4>> keys(mesh.faceCount()); // three sorted corners, face
    for (int face = 0; face < static_cast<int>(keys.size()); ++face) {
        keys[face] = {mesh.faces(face, 0), mesh.faces(face, 1), mesh.faces(face, 2), face};
        std::sort(keys[face].begin(), keys[face].begin() + 3);
    }
    std::ranges::sort(keys);
    std::vector<char> keep(keys.size(), 1);
    for (std::size_t i = 1; i < keys.size(); ++i)
        if (std::equal(keys[i].begin(), keys[i].begin() + 3, keys[i - 1].begin()))
            keep[keys[i][3]] = 0;
    keepRows(mesh.faces, keep);
    return static_cast<int>(std::ranges::count(keep, 0));
}

int keepLargestComponent(Mesh& mesh) {
    const auto components = connectedComponents(mesh);
    const auto areas = faceAreas(mesh);
    std::vector<double> areaOf(components.count, 0);
    std::vector<char> hasFaces(components.count, 0);
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        const int component = components.componentOfVertex[mesh.faces(face, 0)];
        areaOf[component] += areas(face);
        hasFaces[component] = 1;
    }
    const auto largest = std::ranges::max_element(areaOf) - areaOf.begin();
    std::vector<char> keep(mesh.faceCount());
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        keep[face] = components.componentOfVertex[mesh.faces(face, 0)] == largest;
    keepRows(mesh.faces, keep);
    return static_cast<int>(std::ranges::count(hasFaces, 1)) - 1;
}

std::vector<int> dropUnreferencedVertices(Mesh& mesh) {
    std::vector<int> newNumber(mesh.vertexCount(), -1);
    for (const int vertex : mesh.faces.reshaped())
        newNumber[vertex] = 0;
    int count = 0;
    for (Eigen::Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
        if (newNumber[vertex] == 0) {
            newNumber[vertex] = count;
            mesh.vertices.row(count++) = mesh.vertices.row(vertex).eval();
        }
    renumberVertices(mesh, count, newNumber);
    return newNumber;
}

} // namespace idiophone
