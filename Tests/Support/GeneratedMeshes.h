// Generates meshes that only tests need, beside those of ParametricMesh.
#pragma once

#include "Geometry/MeshBuilder.h"
#include "Geometry/ParametricMesh.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace idiophone::test {

/// Returns a flat rectangle of columns × rows rectangles, each cut in two along the same diagonal:
/// (columns+1)(rows+1) vertices.
inline Mesh gridPlateMesh(double lengthMetres, double widthMetres, int columns, int rows) {
    MeshBuilder builder;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            builder.add((static_cast<double>(i) / columns - 0.5) * lengthMetres,
                        (static_cast<double>(j) / rows - 0.5) * widthMetres, 0);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const int a = j * (columns + 1) + i, b = a + columns + 1;
            builder.face(a, a + 1, b + 1);
            builder.face(a, b + 1, b);
        }
    return builder.mesh();
}

/// Returns a flat ring in the xy plane: `rows` + 1 circles of `around` vertices, every other one
/// turned by half a spacing.
inline Mesh annulusMesh(double innerRadiusMetres, double outerRadiusMetres, int around, int rows) {
    MeshBuilder builder;
    for (int row = 0; row <= rows; ++row)
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * std::numbers::pi * (k + (row % 2) * 0.5) / around;
            const double radius =
                innerRadiusMetres + (outerRadiusMetres - innerRadiusMetres) * row / rows;
            builder.add(radius * std::cos(angle), radius * std::sin(angle), 0);
        }
    for (int row = 0; row < rows; ++row)
        for (int k = 0; k < around; ++k) {
            const int next = (k + 1) % around;
            const int a = row * around + k, b = row * around + next;
            const int c = a + around, d = b + around;
            if (row % 2 == 0) {
                builder.face(a, c, b);
                builder.face(b, c, d);
            } else {
                builder.face(a, c, d);
                builder.face(a, d, b);
            }
        }
    return builder.mesh();
}

/// Returns the closed surface of a solid sheet: the flat mesh at z = ± thickness/2, and walls of
/// `layers` rows along its boundary. Vertices come in the order top, bottom, walls.
inline Mesh extrudedMesh(const Mesh& flatMesh, double thicknessMetres, int layers = 1) {
    MeshBuilder builder;
    const auto count = static_cast<int>(flatMesh.vertexCount());
    const auto addAt = [&](int vertex, double height) {
        return builder.add(flatMesh.vertices(vertex, 0), flatMesh.vertices(vertex, 1),
                           (height - 0.5) * thicknessMetres);
    };
    for (const double height : {1.0, 0.0})
        for (int v = 0; v < count; ++v)
            addAt(v, height);
    std::set<std::pair<int, int>> directed;
    for (const auto& face : flatMesh.faces.rowwise()) {
        builder.face(face(0), face(1), face(2));
        builder.face(count + face(0), count + face(2), count + face(1));
        for (int k = 0; k < 3; ++k)
            directed.emplace(face(k), face((k + 1) % 3));
    }
    std::map<std::pair<int, int>, int> wall; // (vertex, layer from below)
    const auto wallVertex = [&](int vertex, int layer) {
        if (layer == 0 || layer == layers)
            return layer == 0 ? count + vertex : vertex;
        const auto [place, isNew] = wall.try_emplace({vertex, layer}, 0);
        if (isNew)
            place->second = addAt(vertex, static_cast<double>(layer) / layers);
        return place->second;
    };
    for (const auto& edge : directed) {
        if (directed.contains({edge.second, edge.first}))
            continue;
        for (int layer = 0; layer < layers; ++layer) {
            const int a = wallVertex(edge.first, layer), b = wallVertex(edge.second, layer),
                      c = wallVertex(edge.second, layer + 1), d = wallVertex(edge.first, layer + 1);
            if (layer % 2 == 0) {
                builder.face(a, b, c);
                builder.face(a, c, d);
            } else {
                builder.face(a, b, d);
                builder.face(b, c, d);
            }
        }
    }
    return builder.mesh();
}

/// Returns a hollow sphere of this mean radius: two closed surfaces with a solid wall between.
inline Mesh hollowSphereMesh(double radiusMetres, double thicknessMetres, int level) {
    const Mesh unit = icosphereMesh(1, level);
    const auto count = unit.vertexCount();
    Mesh mesh{Eigen::MatrixXd(2 * count, 3), Eigen::MatrixXi(2 * unit.faceCount(), 3)};
    mesh.vertices << (radiusMetres + thicknessMetres / 2) * unit.vertices,
        (radiusMetres - thicknessMetres / 2) * unit.vertices;
    mesh.faces << unit.faces,
        (unit.faces.rowwise().reverse().array() + static_cast<int>(count)).matrix();
    return mesh;
}

/// Returns a million triangles without common vertices in the unit cube.
inline Mesh triangleSoup() {
    Mesh soup{Eigen::MatrixXd(3000000, 3), Eigen::MatrixXi(1000000, 3)};
    std::mt19937 random(5);
    for (double& coordinate : soup.vertices.reshaped())
        coordinate = static_cast<double>(random()) / 4294967296.0;
    for (int i = 0; i < 3000000; ++i)
        soup.faces(i / 3, i % 3) = i;
    return soup;
}

} // namespace idiophone::test
