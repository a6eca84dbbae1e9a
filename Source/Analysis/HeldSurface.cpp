#include "Analysis/HeldSurface.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace idiophone {
namespace {

bool areBelow(const std::vector<int>& indices, Eigen::Index count) {
    return std::ranges::all_of(indices, [&](int index) { return index >= 0 && index < count; });
}

/// Returns the faces of `support`, and the vertices with the edges and faces that join them, on the
/// vertices of the mesh.
Mesh heldPart(const Mesh& mesh, const Support& support) {
    std::vector<char> isHeld(static_cast<std::size_t>(mesh.vertexCount()), 0);
    std::vector<Eigen::RowVector3i> faces;
    for (const int face : support.faces)
        faces.emplace_back(mesh.faces.row(face));
    for (const int vertex : support.vertices) {
        isHeld[static_cast<std::size_t>(vertex)] = 1;
        faces.emplace_back(vertex, vertex, vertex);
    }
    for (Eigen::Index face = 0; face < mesh.faceCount() && !support.vertices.empty(); ++face) {
        std::vector<int> corners;
        for (const int corner : mesh.faces.row(face))
            if (isHeld[static_cast<std::size_t>(corner)] != 0)
                corners.push_back(corner);
        if (corners.size() > 1)
            faces.emplace_back(corners[0], corners[1], corners.back());
    }
    Mesh part{mesh.vertices, Eigen::MatrixXi(faces.size(), 3)};
    for (std::size_t i = 0; i < faces.size(); ++i)
        part.faces.row(static_cast<Eigen::Index>(i)) = faces[i];
    return part;
}

} // namespace

Result<std::shared_ptr<const HeldSurface>> HeldSurface::of(const Mesh& mesh,
                                                           const Support& support) {
    if (support.faces.empty() && support.vertices.empty())
        return nullptr;
    if (!areBelow(support.faces, mesh.faceCount()) ||
        !areBelow(support.vertices, mesh.vertexCount()))
        return failure("A clamped part of the mesh does not exist.");
    return std::shared_ptr<const HeldSurface>(new HeldSurface(heldPart(mesh, support), mesh));
}

HeldSurface::HeldSurface(Mesh heldMesh, const Mesh& wholeMesh)
    : held(std::move(heldMesh)), whole(wholeMesh) {
    constexpr double tolerance = 2e-6; // repair joins points within 1e-6 to edges
    toleranceMetres = tolerance * boxOfFaces(wholeMesh).diagonal().norm();
}

bool HeldSurface::holds(const Eigen::Vector3d& pointMetres, double reachMetres) const {
    const double metres = held.nearestPoint(pointMetres).distanceMetres;
    if (metres <= toleranceMetres)
        return true;
    return metres <= reachMetres &&
           metres <= whole.nearestPoint(pointMetres).distanceMetres + toleranceMetres;
}

} // namespace idiophone
