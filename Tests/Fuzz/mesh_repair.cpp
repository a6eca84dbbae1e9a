// What repair and checks make of meshes that no modeller would write: corners on a lattice of few
// points, so that faces meet, fold, repeat and pass through each other.
#include "Fuzz/FuzzTarget.h"
#include "Geometry/MeshCheck.h"
#include "Geometry/MeshRepair.h"

namespace idiophone::fuzz {
namespace {

constexpr std::size_t mostVertices = 64, mostFaces = 200;

/// A byte that says how many vertices there are, three bytes for each, then three for each face.
Mesh latticeMesh(std::string_view bytes) {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    const auto vertices = 1 + at(0) % mostVertices;
    Mesh mesh{Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(vertices), 3), {}};
    std::size_t next = 1;
    for (std::size_t i = 0; i < vertices * 3 && next < bytes.size(); ++i, ++next)
        // Fourths of a lattice's step are off it by less than repair welds, or by more.
        mesh.vertices(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) =
            (at(next) & 15) + (at(next) >> 6) * (at(next) & 32 ? 0.25 : 1e-7);
    const auto faces = std::min(mostFaces, (bytes.size() - next) / 3);
    mesh.faces.resize(static_cast<Eigen::Index>(faces), 3);
    for (std::size_t i = 0; i < faces * 3; ++i, ++next)
        mesh.faces(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) =
            static_cast<int>(at(next) % vertices);
    return mesh;
}

void claimUsable(const Mesh& mesh) {
    claim(mesh.faceCount() > 0 && mesh.vertices.allFinite(), "a repaired mesh has faces");
    claim(mesh.faces.minCoeff() >= 0 && mesh.faces.maxCoeff() < mesh.vertexCount(),
          "faces have vertices");
    claim(faceAreas(mesh).minCoeff() > 0, "faces have areas");
}

void claimManifold(const Mesh& mesh) {
    for (const auto& edge : uniqueEdges(mesh))
        claim(edge.faceCount == 1 || edge.faceCount == 2, "edges of a manifold have two sides");
}

void claimPlausible(const Mesh& mesh) {
    const auto check = checkMesh(mesh);
    const Eigen::RowVector3d extent =
        mesh.vertices.colwise().maxCoeff() - mesh.vertices.colwise().minCoeff();
    claim(check.areaM2 > 0 && std::isfinite(check.areaM2), "a surface has an area");
    claim(!check.isSolid() || check.volumeM3 <= 1.001 * extent.prod(),
          "a solid fits into its bounding box");
}

} // namespace

void examine(std::string_view bytes) {
    if (bytes.empty())
        return;
    const auto mesh = latticeMesh(bytes);
    const auto repaired = repairMesh(mesh);
    if (!repaired)
        return claimSentence(repaired.error());
    claimUsable(repaired->mesh);
    claimPlausible(repaired->mesh);
    claim(repaired->vertexOfInput.size() == static_cast<std::size_t>(mesh.vertexCount()),
          "every vertex is accounted for");
    const auto again = repairMesh(repaired->mesh);
    claim(again && again->report.degenerateFaces + again->report.duplicateFaces == 0,
          "a second repair finds no bad faces");
    const auto cut = repairMesh(mesh, {.cutIntoManifold = true});
    claim(cut.has_value(), "what can be repaired can be cut");
    claimUsable(cut->mesh);
    claimManifold(cut->mesh);
}

} // namespace idiophone::fuzz
