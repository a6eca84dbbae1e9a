// Difficult meshes and mesh checks for the tests of Geometry.
#pragma once

#include "Geometry/ParametricMesh.h"
#include "Mesh/Mesh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace idiophone::test {

inline Mesh joined(const Mesh& a, const Mesh& b) {
    Mesh both{Eigen::MatrixXd(a.vertexCount() + b.vertexCount(), 3),
              Eigen::MatrixXi(a.faceCount() + b.faceCount(), 3)};
    both.vertices << a.vertices, b.vertices;
    both.faces << a.faces, b.faces.array() + static_cast<int>(a.vertexCount());
    return both;
}

inline Mesh moved(Mesh mesh, const Eigen::RowVector3d& by) {
    mesh.vertices.rowwise() += by;
    return mesh;
}

inline Mesh insideOut(Mesh mesh) {
    mesh.faces.col(0).swap(mesh.faces.col(1));
    return mesh;
}

/// Gives every face its own vertices, as in STL files.
inline Mesh soupOf(const Mesh& mesh) {
    Mesh soup{Eigen::MatrixXd(3 * mesh.faceCount(), 3), mesh.faces};
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 0; corner < 3; ++corner) {
            soup.vertices.row(3 * face + corner) = mesh.vertices.row(mesh.faces(face, corner));
            soup.faces(face, corner) = static_cast<int>(3 * face + corner);
        }
    return soup;
}

/// A cube with T-junctions: `segments` per side, but 2 × `segments` on top. Every face has its own
/// vertices.
inline Mesh tJunctionCube(int segments) {
    const Mesh coarse = boxMesh({1, 1, 1}, Eigen::Vector3i::Constant(segments));
    const Mesh fine = boxMesh({1, 1, 1}, Eigen::Vector3i::Constant(2 * segments));
    const auto onTop = [](const Mesh& mesh, Eigen::Index face) {
        return mesh.vertices(mesh.faces(face, 0), 2) > 0.499 &&
               mesh.vertices(mesh.faces(face, 1), 2) > 0.499 &&
               mesh.vertices(mesh.faces(face, 2), 2) > 0.499;
    };
    const auto part = [](const Mesh& mesh, const std::function<bool(Eigen::Index)>& keep) {
        Mesh result{mesh.vertices, Eigen::MatrixXi(0, 3)};
        for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
            if (keep(face)) {
                result.faces.conservativeResize(result.faces.rows() + 1, 3);
                result.faces.row(result.faces.rows() - 1) = mesh.faces.row(face);
            }
        return result;
    };
    return soupOf(joined(part(coarse, [&](Eigen::Index f) { return !onTop(coarse, f); }),
                         part(fine, [&](Eigen::Index f) { return onTop(fine, f); })));
}

/// A grid of quads. `vertexAt(i, j)` may return a vertex twice to close the grid.
inline Mesh gridOf(int columns,
                   int rows,
                   int vertexCount,
                   const std::function<int(int, int)>& vertexAt,
                   const std::function<Eigen::RowVector3d(int, int)>& pointAt) {
    Mesh mesh{Eigen::MatrixXd::Zero(vertexCount, 3), Eigen::MatrixXi(2 * columns * rows, 3)};
    int face = 0;
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j) {
            const int a = vertexAt(i, j), b = vertexAt(i + 1, j), c = vertexAt(i + 1, j + 1),
                      d = vertexAt(i, j + 1);
            mesh.vertices.row(a) = pointAt(i, j);
            mesh.faces.row(face++) << a, b, c;
            mesh.faces.row(face++) << a, c, d;
        }
    for (int i = 0; i <= columns; ++i)
        for (int j = 0; j <= rows; ++j)
            if (i < columns || vertexAt(i, j) == i * (rows + 1) + j)
                mesh.vertices.row(vertexAt(i, j)) = pointAt(i, j);
    return mesh;
}

inline Mesh moebiusStrip(int around, int across) {
    const auto vertexAt = [=](int i, int j) {
        return i == around ? across - j : i * (across + 1) + j;
    };
    return gridOf(around, across, around * (across + 1), vertexAt, [=](int i, int j) {
        const double t = 2 * std::numbers::pi * i / around, s = 0.6 * j / across - 0.3;
        const double r = 1 + s * std::cos(t / 2);
        return Eigen::RowVector3d(r * std::cos(t), r * std::sin(t), s * std::sin(t / 2));
    });
}

inline Mesh kleinBottle(int around, int across) {
    const auto vertexAt = [=](int i, int j) {
        const int k = i == around ? (across - j) % across : j % across;
        return (i % around) * across + k;
    };
    return gridOf(around, across, around * across, vertexAt, [=](int i, int j) {
        const double u = 2 * std::numbers::pi * (i % around) / around,
                     v = 2 * std::numbers::pi * (j % across) / across;
        const double r = 2 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
        return Eigen::RowVector3d(r * std::cos(u), r * std::sin(u),
                                  std::sin(u / 2) * std::sin(v) +
                                      std::cos(u / 2) * std::sin(2 * v));
    });
}

inline Mesh book(int pages) {
    Mesh mesh{Eigen::MatrixXd(pages + 2, 3), Eigen::MatrixXi(pages, 3)};
    mesh.vertices.row(0) << 0, 0, 0;
    mesh.vertices.row(1) << 0, 0, 1;
    for (int page = 0; page < pages; ++page) {
        const double angle = 2 * std::numbers::pi * page / pages;
        mesh.vertices.row(page + 2) << std::cos(angle), std::sin(angle), 0.4;
        mesh.faces.row(page) << 0, 1, page + 2;
    }
    return mesh;
}

/// A cone, open below. All faces meet at its tip.
inline Mesh fanMesh(int faces) {
    Mesh mesh{Eigen::MatrixXd(faces + 1, 3), Eigen::MatrixXi(faces, 3)};
    mesh.vertices.row(faces) << 0, 0, 0.3;
    for (int face = 0; face < faces; ++face) {
        const double angle = 2 * std::numbers::pi * face / faces;
        mesh.vertices.row(face) << std::cos(angle), std::sin(angle), 0;
        mesh.faces.row(face) << faces, face, (face + 1) % faces;
    }
    return mesh;
}

/// Open at z = 0.
inline Mesh openHemisphere(double radiusMetres, int rings) {
    Mesh mesh = discMesh(1, rings);
    for (Eigen::Index v = 0; v < mesh.vertexCount(); ++v) {
        const double r = mesh.vertices.row(v).norm(), angle = r * std::numbers::pi / 2;
        const Eigen::RowVector3d flat =
            r > 0 ? Eigen::RowVector3d(mesh.vertices.row(v) / r) : Eigen::RowVector3d::Zero();
        mesh.vertices.row(v) =
            radiusMetres * (std::sin(angle) * flat + std::cos(angle) * Eigen::RowVector3d::UnitZ());
    }
    return mesh;
}

/// A closed bowl: an outer hemisphere, an inner one, and the rim between them.
inline Mesh bowl(double radiusMetres, double wallMetres, int rings) {
    const Mesh outer = openHemisphere(radiusMetres, rings);
    const Mesh inner = insideOut(openHemisphere(radiusMetres - wallMetres, rings));
    Mesh both = joined(outer, inner);
    const int n = static_cast<int>(outer.vertexCount()), around = 6 * rings, first = n - around;
    const auto faces = both.faceCount();
    both.faces.conservativeResize(faces + 2 * around, 3);
    for (int i = 0; i < around; ++i) {
        const int a = first + i, b = first + (i + 1) % around;
        both.faces.row(faces + 2 * i) << b, a, a + n;
        both.faces.row(faces + 2 * i + 1) << b, a + n, b + n;
    }
    return both;
}

inline Mesh randomSoup(std::mt19937& random, int vertices, int faces) {
    Mesh mesh{Eigen::MatrixXd(vertices, 3), Eigen::MatrixXi(faces, 3)};
    for (double& coordinate : mesh.vertices.reshaped())
        coordinate = static_cast<double>(random()) / 4294967296.0;
    for (int& vertex : mesh.faces.reshaped())
        vertex = static_cast<int>(random() % static_cast<unsigned>(vertices));
    return mesh;
}

/// Returns the longest side over the height of the worst face; infinite for a face without area.
inline double worstAspect(const Mesh& mesh) {
    double worst = 0;
    const auto areas = faceAreas(mesh);
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 0; corner < 3; ++corner) {
            const double length = (mesh.vertices.row(mesh.faces(face, corner)) -
                                   mesh.vertices.row(mesh.faces(face, (corner + 1) % 3)))
                                      .norm();
            worst = std::max(worst, length * length / (2 * areas(face)));
        }
    return worst;
}

/// Returns true if every edge has one or two faces that run along it in opposite directions, and
/// the faces at every vertex form one fan.
inline bool isOrientedManifold(const Mesh& mesh) {
    std::map<std::pair<int, int>, int> faceOfHalfEdge;
    for (int face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 0; corner < 3; ++corner)
            if (!faceOfHalfEdge
                     .emplace(
                         std::pair{mesh.faces(face, corner), mesh.faces(face, (corner + 1) % 3)},
                         face)
                     .second)
                return false;
    std::vector<int> facesAt(static_cast<std::size_t>(mesh.vertexCount()), 0), someFace(facesAt);
    for (int face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 0; corner < 3; ++corner) {
            ++facesAt[mesh.faces(face, corner)];
            someFace[mesh.faces(face, corner)] = face;
        }
    for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
        int reached = 1;
        for (const bool forward : {true, false}) {
            int face = someFace[vertex];
            for (int steps = 0; steps < facesAt[vertex]; ++steps) {
                int corner = 0;
                while (mesh.faces(face, corner) != vertex)
                    ++corner;
                const int other = mesh.faces(face, (corner + (forward ? 1 : 2)) % 3);
                const auto next = faceOfHalfEdge.find(forward ? std::pair{other, vertex}
                                                              : std::pair{vertex, other});
                if (next == faceOfHalfEdge.end() || next->second == someFace[vertex])
                    break;
                face = next->second;
                ++reached;
            }
            if (reached == facesAt[vertex])
                break;
        }
        if (facesAt[vertex] == 0 || reached != facesAt[vertex])
            return false;
    }
    return true;
}

} // namespace idiophone::test
