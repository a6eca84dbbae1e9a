#include "Geometry/CgalSurface.h"

#include "Geometry/MeshCleaning.h"
#include "Geometry/MeshRepair.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <array>
#include <vector>

namespace idiophone {

Eigen::RowVector3d UnitSurface::unitPoint(Surface::Vertex_index vertex) const {
    const auto& point = surface.point(vertex);
    return {point.x(), point.y(), point.z()};
}

UnitSurface unitSurfaceOf(const Mesh& sound) {
    UnitSurface result;
    result.centreMetres =
        (sound.vertices.colwise().maxCoeff() + sound.vertices.colwise().minCoeff()) / 2;
    result.diagonalMetres = boundingDiagonalMetres(sound);
    for (Eigen::Index vertex = 0; vertex < sound.vertexCount(); ++vertex) {
        const Eigen::RowVector3d point =
            (sound.vertices.row(vertex) - result.centreMetres) / result.diagonalMetres;
        result.surface.add_vertex({point.x(), point.y(), point.z()});
    }
    std::vector<std::array<Surface::Vertex_index, 3>> faces;
    faces.reserve(sound.faceCount());
    for (Eigen::Index face = 0; face < sound.faceCount(); ++face)
        faces.push_back({Surface::Vertex_index(static_cast<unsigned>(sound.faces(face, 0))),
                         Surface::Vertex_index(static_cast<unsigned>(sound.faces(face, 1))),
                         Surface::Vertex_index(static_cast<unsigned>(sound.faces(face, 2)))});
    CGAL::Euler::add_faces(faces, result.surface);
    return result;
}

Result<Mesh> meshOf(UnitSurface& unit) {
    unit.surface.collect_garbage();
    Mesh mesh{Eigen::MatrixXd(unit.surface.number_of_vertices(), 3),
              Eigen::MatrixXi(unit.surface.number_of_faces(), 3)};
    for (const auto vertex : unit.surface.vertices())
        mesh.vertices.row(static_cast<int>(vertex)) =
            unit.unitPoint(vertex) * unit.diagonalMetres + unit.centreMetres;
    for (const auto face : unit.surface.faces()) {
        int corner = 0;
        for (const auto vertex : unit.surface.vertices_around_face(unit.surface.halfedge(face)))
            mesh.faces(static_cast<int>(face), corner++) = static_cast<int>(vertex);
    }
    if (!mesh.vertices.allFinite())
        return failure("The mesh cannot be remeshed: its faces are too thin for arithmetic.");
    Mesh withoutDegenerate = mesh;
    if (dropDegenerateFaces(withoutDegenerate) == 0) {
        dropUnreferencedVertices(mesh);
        if (mesh.faceCount() == 0)
            return failure("The mesh has nothing left at this edge length.");
        return mesh;
    }
    auto repaired = repairMesh(mesh, {.weldTolerance = 0, .cutIntoManifold = true});
    if (!repaired)
        return tl::unexpected(std::move(repaired.error()));
    return std::move(repaired->mesh);
}

} // namespace idiophone
