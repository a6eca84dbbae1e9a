#include "Geometry/ParametricMesh.h"

#include "Geometry/MeshBuilder.h"
#include "Geometry/Subdivision.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace idiophone {
namespace {

constexpr double pi = std::numbers::pi;

int sheetVertexCount(const SheetGrid& grid) {
    const int longRows = grid.rowsAcross / 2, evenRows = longRows + 1;
    return evenRows * (grid.segmentsAlong + 1) + longRows * (grid.segmentsAlong + 2);
}

/// A row of a sheet.
struct Row {
    std::vector<int> vertices;
    std::vector<double> shares; ///< of the length, 0 to 1

    int steps() const { return static_cast<int>(vertices.size()) - 1; }
    int vertex(int k) const { return vertices[k]; }
    double place(int k) const { return shares[k]; }
};

} // namespace

SheetGrid sheetGrid(double lengthMetres, double widthMetres, int targetVertices) {
    SheetGrid best;
    int minimumMiss = -1;
    for (int rows = 2; rows <= 2000; rows += 2) {
        const double spacing = 2 / std::sqrt(3.0) * widthMetres / rows;
        // The middle row has a vertex at x = 0 if its parity fits the number of segments.
        const bool odd = rows % 4 == 2;
        int segments = 2 * static_cast<int>(std::lround((lengthMetres / spacing - odd) / 2)) + odd;
        segments = std::max(segments, odd ? 3 : 2);
        const SheetGrid grid{segments, rows};
        const int count = sheetVertexCount(grid);
        if (const int miss = std::abs(count - targetVertices);
            minimumMiss < 0 || miss < minimumMiss) {
            minimumMiss = miss;
            best = grid;
        }
        if (count > 2 * targetVertices)
            break;
    }
    return best;
}

Mesh sheetMesh(double lengthMetres, double widthMetres, const SheetGrid& grid) {
    MeshBuilder builder;
    Row previous;
    for (int row = 0; row <= grid.rowsAcross; ++row) {
        Row current;
        auto& xs = current.shares;
        if (row % 2 == 0) {
            for (int i = 0; i <= grid.segmentsAlong; ++i)
                xs.push_back(static_cast<double>(i) / grid.segmentsAlong);
        } else {
            xs.push_back(0);
            for (int i = 0; i < grid.segmentsAlong; ++i)
                xs.push_back((i + 0.5) / grid.segmentsAlong);
            xs.push_back(1);
        }
        const double y = (static_cast<double>(row) / grid.rowsAcross - 0.5) * widthMetres;
        for (const double x : xs)
            current.vertices.push_back(builder.add((x - 0.5) * lengthMetres, y, 0));
        if (row > 0)
            builder.stitch(previous, current);
        previous = std::move(current);
    }
    return builder.mesh();
}

Mesh sheetMesh(double lengthMetres, double widthMetres, int targetVertices) {
    return sheetMesh(lengthMetres, widthMetres,
                     sheetGrid(lengthMetres, widthMetres, targetVertices));
}

Mesh discMesh(double radiusMetres, int rings) {
    MeshBuilder builder;
    builder.add(0, 0, 0);
    for (int ring = 1; ring <= rings; ++ring)
        for (int k = 0; k < 6 * ring; ++k) {
            const double radius = radiusMetres * ring / rings, angle = 2 * pi * k / (6 * ring);
            builder.add(radius * std::cos(angle), radius * std::sin(angle), 0);
        }
    const auto index = [](int ring, int k) {
        return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + k % (6 * ring);
    };
    for (int ring = 1; ring <= rings; ++ring)
        for (int sector = 0; sector < 6; ++sector)
            for (int k = 0; k < ring; ++k) {
                const int outer = sector * ring + k, inner = sector * (ring - 1) + k;
                builder.face(index(ring - 1, inner), index(ring, outer), index(ring, outer + 1));
                if (k + 1 < ring)
                    builder.face(index(ring - 1, inner), index(ring, outer + 1),
                                 index(ring - 1, inner + 1));
            }
    return builder.mesh();
}

Mesh boxMesh(const Eigen::Vector3d& sizeMetres, const Eigen::Vector3i& segments) {
    MeshBuilder builder;
    std::map<std::array<int, 3>, int> known;
    const auto vertex = [&](const std::array<int, 3>& at) {
        const auto [place, isNew] = known.try_emplace(at, 0);
        if (isNew) {
            Eigen::Vector3d p;
            for (int axis = 0; axis < 3; ++axis)
                p(axis) = (static_cast<double>(at[axis]) / segments(axis) - 0.5) * sizeMetres(axis);
            place->second = builder.add(p.x(), p.y(), p.z());
        }
        return place->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, segments(axis)}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            for (int j = 0; j < segments(v); ++j)
                for (int i = 0; i < segments(u); ++i) {
                    const auto corner = [&](int di, int dj) {
                        std::array<int, 3> at{};
                        at[axis] = side, at[u] = i + di, at[v] = j + dj;
                        return vertex(at);
                    };
                    const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1),
                              d = corner(0, 1);
                    if (side == 0) {
                        builder.face(a, c, b);
                        builder.face(a, d, c);
                    } else {
                        builder.face(a, b, c);
                        builder.face(a, c, d);
                    }
                }
        }
    return builder.mesh();
}

Mesh icosphereMesh(double radiusMetres, int level) {
    const double g = std::numbers::phi;
    MeshBuilder builder;
    for (const double s : {-1.0, 1.0})
        for (const double t : {-g, g}) {
            builder.add(0, s, t);
            builder.add(s, t, 0);
            builder.add(t, 0, s);
        }
    // Faces are the triples of vertices that are 2 apart, the icosahedron's edge length.
    const auto near = [&](int a, int b) {
        return (builder.vertices[a] - builder.vertices[b]).norm() < 2.1;
    };
    for (int a = 0; a < 12; ++a)
        for (int b = a + 1; b < 12; ++b)
            for (int c = b + 1; c < 12; ++c)
                if (near(a, b) && near(b, c) && near(a, c)) {
                    const auto &p = builder.vertices[a], &q = builder.vertices[b],
                               &r = builder.vertices[c];
                    if ((q - p).cross(r - p).dot(p) > 0)
                        builder.face(a, b, c);
                    else
                        builder.face(a, c, b);
                }
    for (auto& vertex : builder.vertices)
        vertex.normalize();
    Mesh mesh = builder.mesh();
    for (int step = 0; step < level; ++step) {
        const auto [fromCoarse, faces] = splitInFour(mesh);
        const Eigen::Index before = mesh.vertexCount();
        mesh = {fromCoarse * mesh.vertices, faces};
        for (Eigen::Index vertex = before; vertex < mesh.vertexCount(); ++vertex)
            mesh.vertices.row(vertex) = Eigen::RowVector3d(mesh.vertices.row(vertex)).normalized();
    }
    mesh.vertices *= radiusMetres;
    return mesh;
}

Mesh torusMesh(double radiusMetres, double sectionRadiusMetres, int sections, int sidesOfSection) {
    MeshBuilder builder;
    for (int i = 0; i < sections; ++i)
        for (int j = 0; j < sidesOfSection; ++j) {
            const double u = 2 * pi * i / sections;
            const double v = 2 * pi * (j + (i % 2) * 0.5) / sidesOfSection;
            const double r = radiusMetres + sectionRadiusMetres * std::cos(v);
            builder.add(r * std::cos(u), r * std::sin(u), sectionRadiusMetres * std::sin(v));
        }
    for (int i = 0; i < sections; ++i)
        for (int j = 0; j < sidesOfSection; ++j) {
            const auto at = [&](int section, int side) {
                return section % sections * sidesOfSection + side % sidesOfSection;
            };
            const int a = at(i, j), b = at(i, j + 1);
            if (i % 2 == 0) { // the next section's vertex j lies between a and b
                builder.face(a, at(i + 1, j), b);
                builder.face(b, at(i + 1, j), at(i + 1, j + 1));
            } else {
                builder.face(a, at(i + 1, j + 1), b);
                builder.face(a, at(i + 1, j), at(i + 1, j + 1));
            }
        }
    return builder.mesh();
}

Mesh hoopMesh(double radiusMetres, double heightMetres, int around, int rows) {
    MeshBuilder builder;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i < around; ++i) {
            const double angle = 2 * pi * (i + (j % 2) * 0.5) / around;
            builder.add(radiusMetres * std::cos(angle), radiusMetres * std::sin(angle),
                        (static_cast<double>(j) / rows - 0.5) * heightMetres);
        }
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < around; ++i) {
            const int next = (i + 1) % around, low = j * around, high = low + around;
            if (j % 2 == 0) {
                builder.face(low + i, low + next, high + i);
                builder.face(low + next, high + next, high + i);
            } else {
                builder.face(low + i, high + next, high + i);
                builder.face(low + i, low + next, high + next);
            }
        }
    return builder.mesh();
}

Mesh tubeMesh(double outerRadiusMetres, double innerRadiusMetres, double lengthMetres, int around) {
    // The circles of the section, in order around the wall.
    const std::array<std::pair<double, double>, 4> section{
        {{outerRadiusMetres, -lengthMetres / 2},
         {outerRadiusMetres, lengthMetres / 2},
         {innerRadiusMetres, lengthMetres / 2},
         {innerRadiusMetres, -lengthMetres / 2}}};
    MeshBuilder builder;
    for (const auto& [radius, z] : section)
        for (int i = 0; i < around; ++i)
            builder.add(radius * std::cos(2 * pi * i / around),
                        radius * std::sin(2 * pi * i / around), z);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < around; ++i) {
            const int next = (i + 1) % around, low = j * around, high = (j + 1) % 4 * around;
            builder.face(low + i, low + next, high + i);
            builder.face(low + next, high + next, high + i);
        }
    return builder.mesh();
}

} // namespace idiophone
