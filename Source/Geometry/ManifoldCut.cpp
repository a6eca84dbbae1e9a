#include "Geometry/ManifoldCut.h"

#include "Geometry/EdgeSplit.h"
#include "Mesh/DisjointSets.h"
#include "Mesh/FaceSides.h"

#include <algorithm>
#include <numeric>
#include <tuple>
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

/// Returns the lower face of the pair at a side, or the side's own face if it has no partner.
int pairAt(const FaceSide& side, const EdgePairing& pairing) {
    const int partner = pairing.partners[side.face][side.corner].face;
    return partner < 0 ? side.face : std::min(side.face, partner);
}

/// If several pairs run between the same two vertices, inserts a vertex in the middle of all but
/// the first.
void separatePairs(Mesh& mesh, const EdgePairing& pairing, std::vector<int>& copyOf) {
    std::unordered_map<int, EdgeInsertions> insertions;
    std::vector<Eigen::RowVector3d> middles;
    auto sides = sortedFaceSides(mesh);
    std::ranges::sort(sides, {}, [&](const FaceSide& side) {
        return std::tuple(side.low, side.high, pairAt(side, pairing), side.face, side.corner);
    });
    for (std::size_t i = 1; i < sides.size(); ++i) {
        const FaceSide &side = sides[i], &before = sides[i - 1];
        if (!side.isAlong(before))
            continue;
        if (pairAt(side, pairing) != pairAt(before, pairing)) {
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
