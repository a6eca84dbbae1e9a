#include "Geometry/ManifoldCut.h"

#include "Geometry/DisjointSets.h"
#include "Geometry/EdgeSplit.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace idiophone {
namespace {

int cornerOf(const Mesh& mesh, int face, int vertex) {
    int corner = 0;
    while (mesh.faces(face, corner) != vertex)
        ++corner;
    return 3 * face + corner;
}

/// Returns for each corner (3·face + corner) the first corner of its fan.
std::vector<int> fansOfCorners(const Mesh& mesh, const EdgePairing& pairing) {
    DisjointSets fans(static_cast<std::size_t>(mesh.faceCount()) * 3);
    for (int face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 0; corner < 3; ++corner) {
            const int partner = pairing.partners[face][corner].face;
            if (partner < 0)
                continue;
            for (const int end : {corner, (corner + 1) % 3}) {
                const int vertex = mesh.faces(face, end);
                fans.join(3 * face + end, cornerOf(mesh, partner, vertex));
            }
        }
    std::vector<int> firstCorners(static_cast<std::size_t>(mesh.faceCount()) * 3);
    for (int corner = 0; corner < static_cast<int>(firstCorners.size()); ++corner)
        firstCorners[corner] = fans.nameOf(corner);
    return firstCorners;
}

void separateFans(Mesh& mesh, const std::vector<int>& fans, std::vector<int>& copyOf) {
    std::vector<char> isTaken(mesh.vertexCount(), 0);
    std::vector<int> vertexOfFan(fans.size(), -1);
    for (int corner = 0; corner < static_cast<int>(fans.size()); ++corner) {
        int& vertex = vertexOfFan[fans[corner]];
        if (vertex < 0) {
            vertex = mesh.faces(corner / 3, corner % 3);
            if (isTaken[vertex]) {
                copyOf.push_back(vertex);
                vertex = static_cast<int>(copyOf.size()) - 1;
            } else {
                isTaken[vertex] = 1;
            }
        }
        mesh.faces(corner / 3, corner % 3) = vertex;
    }
    const Eigen::MatrixXd vertices = std::move(mesh.vertices);
    mesh.vertices.resize(copyOf.size(), 3);
    for (std::size_t vertex = 0; vertex < copyOf.size(); ++vertex)
        mesh.vertices.row(vertex) = vertices.row(copyOf[vertex]);
}

/// A side of a face. `pair` is the lower face of the pair, or the face itself if it has no partner.
struct Side {
    int low = 0, high = 0, pair = 0, face = 0, corner = 0;
    auto operator<=>(const Side&) const = default;
};

std::vector<Side> sortedSides(const Mesh& mesh, const EdgePairing& pairing) {
    std::vector<Side> sides;
    sides.reserve(static_cast<std::size_t>(mesh.faceCount()) * 3);
    for (int face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 0; corner < 3; ++corner) {
            const auto [low, high] =
                std::minmax({mesh.faces(face, corner), mesh.faces(face, (corner + 1) % 3)});
            const int partner = pairing.partners[face][corner].face;
            sides.push_back(
                {low, high, partner < 0 ? face : std::min(face, partner), face, corner});
        }
    std::ranges::sort(sides);
    return sides;
}

/// If several pairs run between the same two vertices, inserts a vertex in the middle of all but
/// the first.
void separatePairs(Mesh& mesh, const EdgePairing& pairing, std::vector<int>& copyOf) {
    std::unordered_map<int, EdgeInsertions> insertions;
    std::vector<Eigen::RowVector3d> middles;
    const auto sides = sortedSides(mesh, pairing);
    for (std::size_t i = 1; i < sides.size(); ++i) {
        const Side &side = sides[i], &before = sides[i - 1];
        const bool sameEdge = side.low == before.low && side.high == before.high;
        if (!sameEdge)
            continue;
        if (side.pair != before.pair) {
            middles.emplace_back((mesh.vertices.row(side.low) + mesh.vertices.row(side.high)) / 2);
            copyOf.push_back(-1);
            insertions[side.face][side.corner] = {static_cast<int>(copyOf.size()) - 1};
        } else if (const auto first = insertions.find(before.face);
                   first != insertions.end() && !first->second[before.corner].empty()) {
            insertions[side.face][side.corner] = first->second[before.corner];
        }
    }
    mesh.vertices.conservativeResize(copyOf.size(), Eigen::NoChange);
    for (std::size_t i = 0; i < middles.size(); ++i)
        mesh.vertices.row(mesh.vertexCount() - static_cast<Eigen::Index>(middles.size() - i)) =
            middles[i];
    splitFaces(mesh, insertions);
}

} // namespace

std::vector<int> cutIntoManifold(Mesh& mesh, const EdgePairing& pairing) {
    std::vector<int> copyOf(mesh.vertexCount());
    std::iota(copyOf.begin(), copyOf.end(), 0);
    separateFans(mesh, fansOfCorners(mesh, pairing), copyOf);
    separatePairs(mesh, pairing, copyOf);
    return copyOf;
}

} // namespace idiophone
