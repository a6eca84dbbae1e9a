#include "Geometry/VertexWelding.h"

#include "Geometry/MeshCleaning.h"
#include "Geometry/VertexTree.h"

#include <CGAL/Fuzzy_sphere.h>
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
    renumberVertices(mesh, count, newNumber);
    return newNumber;
}

} // namespace idiophone
