// Fuzzes repair, checks and subdivision with degenerate meshes.
#include "Fuzz/FuzzTarget.h"
#include "Fuzz/LatticeMesh.h"
#include "Geometry/MeshCheck.h"
#include "Geometry/MeshRepair.h"
#include "Geometry/Subdivision.h"

namespace idiophone::fuzz {
namespace {

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

void claimSmooth(const Mesh& mesh) {
    const auto fine = subdivided(mesh, 1);
    claim(fine.vertices.allFinite() && fine.faces.minCoeff() >= 0 &&
              fine.faces.maxCoeff() < fine.vertexCount(),
          "what was subdivided has faces between vertices");
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
    for (const auto* each : {&mesh, &repaired->mesh, &cut->mesh})
        claimSmooth(*each);
}

} // namespace idiophone::fuzz
