#include "Geometry/GroupNames.h"
#include "Geometry/MeshFile.h"
#include "Gltf/GltfFile.h"
#include "Gltf/GltfMeshes.h"

#include <array>
#include <utility>

namespace idiophone {

Result<RawMesh> readGltf(std::string_view bytes, const std::filesystem::path& folder) {
    const auto document = GltfDocument::parse(bytes, buffersIn(folder));
    if (!document)
        return failure(document.error().message);
    auto meshes = meshesOf(*document);
    if (!meshes)
        return failure(meshes.error().message);
    if (meshes->parts.empty())
        return failure("its scene shows no triangles");
    RawMesh all;
    all.isInMetres = true;
    all.notes = std::move(meshes->notes);
    GroupNames groupNames(all.groups);
    for (auto& part : meshes->parts) {
        const auto mesh = std::exchange(part.mesh, {}); // frees its memory
        const auto group = groupNames.numberOf(part.name);
        const auto first = all.vertexCount();
        for (const auto& vertex : mesh.vertices.rowwise()) // glTF's y points up
            for (const double metres : {vertex.x(), -vertex.z(), vertex.y()})
                all.coordinates.push_back(metres);
        for (const auto& face : mesh.faces.rowwise()) {
            all.addPolygon(std::array{first + face(0), first + face(1), first + face(2)});
            groupNames.addTo(group, all.polygonEnds.size() - 1);
        }
    }
    return all;
}

} // namespace idiophone
