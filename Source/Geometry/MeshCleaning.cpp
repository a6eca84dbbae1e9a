#include "Geometry/MeshCleaning.h"

#include "Geometry/VertexTree.h"

#include <CGAL/Fuzzy_sphere.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace idiophone {
namespace {

/// Returns for each vertex the first vertex at exactly the same position.
std::vector<int> firstInPlace(const Eigen::MatrixXd& vertices) {
    std::vector<std::pair<std::array<double, 3>, int>> places;
    places.reserve(vertices.rows());
    for (int vertex = 0; vertex < vertices.rows(); ++vertex)
        places.push_back({{vertices(vertex, 0), vertices(vertex, 1), vertices(vertex, 2)}, vertex});
    std::ranges::sort(places);
    std::vector<int> result(places.size());
    int first = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i == 0 || places[i].first != places[i - 1].first)
            first = places[i].second;
        result[places[i].second] = first;
    }
    return result;
}

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

/// Keeps the first `count` vertices and gives the faces' corners their new numbers.
void renumber(Mesh& mesh, int count, const std::vector<int>& newNumber) {
    mesh.vertices.conservativeResize(count, Eigen::NoChange);
    mesh.faces = mesh.faces.unaryExpr([&](int vertex) { return newNumber[vertex]; }).eval();
}

} // namespace

std::vector<int> weldVertices(Mesh& mesh, double toleranceMetres) {
    // CGAL's tree degenerates into a list if many points coincide.
    const auto first = firstInPlace(mesh.vertices);
    VertexTree tree;
    for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
        if (first[vertex] == vertex)
            tree.insert(numberedPoint(mesh.vertices, vertex));
    tree.build();
    std::vector<int> newNumber(mesh.vertexCount(), -1);
    std::vector<NumberedPoint> near;
    int count = 0;
    // Compares distances, because the cell borders of a grid would separate close vertices.
    for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
        if (first[vertex] != vertex)
            newNumber[vertex] = newNumber[first[vertex]];
        if (newNumber[vertex] >= 0)
            continue;
        near.clear();
        tree.search(std::back_inserter(near),
                    CGAL::Fuzzy_sphere<VertexTreeTraits>(numberedPoint(mesh.vertices, vertex).first,
                                                         toleranceMetres));
        newNumber[vertex] = count;
        for (const auto& [point, other] : near)
            if (newNumber[other] < 0)
                newNumber[other] = count;
        mesh.vertices.row(count++) = mesh.vertices.row(vertex).eval();
    }
    renumber(mesh, count, newNumber);
    return newNumber;
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
    renumber(mesh, count, newNumber);
    return newNumber;
}

} // namespace idiophone
