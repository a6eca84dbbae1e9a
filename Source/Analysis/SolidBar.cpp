#include "Analysis/SolidBar.h"

#include "Geometry/MeshBuilder.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace idiophone {
namespace {

/// A grid of corners and mid-edges. Even coordinates are corners.
struct Lattice {
    Eigen::Vector3i points; ///< along each axis

    explicit Lattice(const BarGrid& grid)
        : points(2 * grid.along + 1, 2 * grid.across + 1, 2 * grid.through + 1) {}

    int index(const Eigen::Vector3i& at) const {
        return at.x() + points.x() * (at.y() + points.y() * at.z());
    }
    int count() const { return points.prod(); }
};

/// Returns the positions of the lines across, symmetric, with two of them on the arch's edges.
std::vector<double> linesAlong(const UndercutBar& bar, int along) {
    const double half = bar.lengthMetres / 2, edge = bar.archHalfLengthShare * bar.lengthMetres;
    const int halfLines = along / 2;
    const int inArch =
        std::clamp(static_cast<int>(std::lround(halfLines * edge / half)), 1, halfLines - 1);
    std::vector<double> right;
    for (int k = 0; k < inArch; ++k)
        right.push_back(edge * k / inArch);
    for (int k = inArch; k <= halfLines; ++k)
        right.push_back(
            std::lerp(edge, half, static_cast<double>(k - inArch) / (halfLines - inArch)));
    std::vector<double> all;
    for (int k = halfLines; k > 0; --k)
        all.push_back(-right[k]);
    all.insert(all.end(), right.begin(), right.end());
    return all;
}

/// Boxes in the left and front halves are mirrored, so that the bar is symmetric.
bool isMirrored(int box, int boxes) {
    return 2 * box < boxes;
}

Eigen::MatrixXd latticePlaces(const UndercutBar& bar, const BarGrid& grid, const Lattice& lattice) {
    const auto lines = linesAlong(bar, grid.along);
    const auto corner = [&](int i, int j, int k) {
        const double x = lines[i];
        const double down = 1 - static_cast<double>(k) / grid.through;
        return Eigen::Vector3d(x, bar.widthMetres * (static_cast<double>(j) / grid.across - 0.5),
                               -heightMetresAt(bar, x) * down);
    };
    Eigen::MatrixXd places(lattice.count(), 3);
    for (int k = 0; k < lattice.points.z(); ++k)
        for (int j = 0; j < lattice.points.y(); ++j)
            for (int i = 0; i < lattice.points.x(); ++i) {
                // The middle of the edge between these two corners, mirrored as in addBox.
                int first = i / 2, second = (i + 1) / 2;
                if (isMirrored(first, grid.along))
                    std::swap(first, second);
                places.row(lattice.index({i, j, k})) =
                    (corner(first, j / 2, k / 2) + corner(second, (j + 1) / 2, (k + 1) / 2)) / 2;
            }
    return places;
}

/// Adds the six tetrahedra of Kuhn's division of a box. Each is a path between opposite corners
/// that takes the axes in another order.
void addBox(const Lattice& lattice,
            const Eigen::Vector3i& box,
            const Eigen::Vector3i& direction,
            std::vector<std::array<int, 10>>& tetrahedra) {
    std::array<int, 3> axes{0, 1, 2};
    do {
        std::array<Eigen::Vector3i, 4> corners;
        for (int axis = 0; axis < 3; ++axis)
            corners[0](axis) = 2 * (box(axis) + (direction(axis) > 0 ? 0 : 1));
        for (std::size_t step = 0; step < 3; ++step) {
            corners[step + 1] = corners[step];
            corners[step + 1](axes[step]) += 2 * direction(axes[step]);
        }
        Eigen::Matrix3i edges;
        for (int step = 0; step < 3; ++step)
            edges.col(step) = corners[step + 1] - corners[0];
        if (edges.cast<double>().determinant() < 0)
            std::swap(corners[1], corners[2]);
        std::array<int, 10> nodes;
        for (std::size_t c = 0; c < 4; ++c)
            nodes[c] = lattice.index(corners[c]);
        for (std::size_t e = 0; e < tetrahedronEdges.size(); ++e) {
            const auto [a, b] = tetrahedronEdges[e];
            nodes[4 + e] = lattice.index((corners[a] + corners[b]) / 2);
        }
        tetrahedra.push_back(nodes);
    } while (std::next_permutation(axes.begin(), axes.end()));
}

/// The corners of each face, seen from outside a positive tetrahedron, and the nodes between them.
constexpr std::array<std::array<int, 6>, 4> faceNodes{
    {{0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {2, 0, 3, 6, 7, 9}}};

/// Returns four triangles for each face that belongs to one tetrahedron only.
Eigen::MatrixXi boundaryTriangles(const std::vector<std::array<int, 10>>& tetrahedra) {
    std::map<std::array<int, 3>, std::pair<int, std::array<int, 6>>> faces;
    for (const auto& tetrahedron : tetrahedra)
        for (const auto& face : faceNodes) {
            std::array<int, 6> nodes;
            for (std::size_t k = 0; k < 6; ++k)
                nodes[k] = tetrahedron[face[k]];
            std::array<int, 3> key{nodes[0], nodes[1], nodes[2]};
            std::ranges::sort(key);
            auto& entry = faces[key];
            ++entry.first;
            entry.second = nodes;
        }
    MeshBuilder triangles;
    for (const auto& [key, entry] : faces) {
        if (entry.first > 1)
            continue;
        const auto& n = entry.second; // n[3] is between 0 and 1, n[4] 1 and 2, n[5] 2 and 0
        triangles.face(n[0], n[3], n[5]);
        triangles.face(n[1], n[4], n[3]);
        triangles.face(n[2], n[5], n[4]);
        triangles.face(n[3], n[4], n[5]);
    }
    return triangles.mesh().faces;
}

/// Takes every second line across, with three points on top and two below.
BarOutline outlineOf(const BarGrid& grid, const Lattice& lattice, const std::vector<int>& number) {
    const int lines = grid.along / 2 + 1, across = BarOutline::topAcross;
    BarOutline outline;
    outline.topCount = lines * across;
    const auto add = [&](int line, int j, int k) {
        outline.surfaceVertices.push_back(number[lattice.index({4 * line, 2 * j, 2 * k})]);
    };
    for (int j = 0; j < across; ++j)
        for (int line = 0; line < lines; ++line)
            add(line, j * grid.across / 2, grid.through);
    for (int line = 0; line < lines; ++line)
        for (const int j : {0, grid.across})
            add(line, j, 0);

    MeshBuilder faces;
    const auto quad = [&](int a, int b, int c, int d) {
        faces.face(a, b, c);
        faces.face(a, c, d);
    };
    const auto top = [&](int line, int j) { return j * lines + line; };
    const auto bottom = [&](int line, int side) { return outline.topCount + 2 * line + side; };
    for (int line = 0; line + 1 < lines; ++line) {
        const int next = line + 1;
        for (int j = 0; j + 1 < across; ++j)
            quad(top(line, j), top(next, j), top(next, j + 1), top(line, j + 1));
        quad(bottom(line, 0), bottom(line, 1), bottom(next, 1), bottom(next, 0));
        quad(bottom(line, 0), bottom(next, 0), top(next, 0), top(line, 0));
        quad(bottom(next, 1), bottom(line, 1), top(line, 2), top(next, 2));
    }
    const int last = lines - 1;
    quad(bottom(0, 0), top(0, 0), top(0, 1), bottom(0, 1));
    faces.face(top(0, 1), top(0, 2), bottom(0, 1));
    quad(bottom(last, 1), top(last, 2), top(last, 1), bottom(last, 0));
    faces.face(top(last, 1), top(last, 0), bottom(last, 0));
    outline.mesh.faces = faces.mesh().faces;
    return outline;
}

} // namespace

SolidBar solidBar(const UndercutBar& bar, const BarGrid& grid) {
    const Lattice lattice(grid);
    std::vector<std::array<int, 10>> tetrahedra;
    for (int k = 0; k < grid.through; ++k)
        for (int j = 0; j < grid.across; ++j)
            for (int i = 0; i < grid.along; ++i)
                addBox(lattice, {i, j, k},
                       {isMirrored(i, grid.along) ? -1 : 1, isMirrored(j, grid.across) ? -1 : 1, 1},
                       tetrahedra);
    const auto triangles = boundaryTriangles(tetrahedra);

    // Surface nodes come first, in the lattice's order.
    std::vector<char> onSurface(lattice.count(), 0);
    for (const int node : triangles.reshaped())
        onSurface[node] = 1;
    std::vector<int> order(onSurface.size());
    std::iota(order.begin(), order.end(), 0);
    const auto inside =
        std::ranges::stable_partition(order, [&](int node) { return onSurface[node] != 0; });
    const int surfaceCount = static_cast<int>(inside.begin() - order.begin());
    std::vector<int> number(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        number[order[k]] = static_cast<int>(k);

    SolidBar result;
    result.elements.nodes = latticePlaces(bar, grid, lattice)(order, Eigen::all);
    result.elements.surfaceVertexCount = surfaceCount;
    result.elements.tetrahedra.resize(tetrahedra.size(), 10);
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
        for (std::size_t k = 0; k < 10; ++k)
            result.elements.tetrahedra(t, k) = number[tetrahedra[t][k]];
    result.surface.vertices = result.elements.nodes.topRows(surfaceCount);
    result.surface.faces = triangles.unaryExpr([&](int node) { return number[node]; });
    result.outline = outlineOf(grid, lattice, number);
    result.outline.mesh.vertices =
        result.surface.vertices(result.outline.surfaceVertices, Eigen::all);
    return result;
}

} // namespace idiophone
