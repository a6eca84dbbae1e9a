#include "Fuzz/MeshFormat.h"

#include "Geometry/MeshReader.h"
#include "Geometry/MeshWriter.h"

#include <algorithm>

namespace idiophone::fuzz {
namespace {

void claimWritable(const Mesh& mesh, const std::string& name) {
    const auto file = scratchFile({}, name);
    claim(writeMesh(mesh, file).has_value(), "a mesh can be written");
    const auto again = readMesh(file);
    claim(again && again->vertices == mesh.vertices && again->faces == mesh.faces,
          "a mesh that was written reads back equal");
}

} // namespace

void examineMesh(std::string_view bytes, const std::string& extension) {
    const auto file = readMeshFile(scratchFile(bytes, "fuzz" + extension));
    if (!file)
        return claimSentence(file.error());
    const Mesh* const mesh = &file->mesh;
    claim(file->groups.size() <= maximumMeshGroups, "the groups are bounded");
    for (const auto& [name, faces] : file->groups)
        claim(!name.empty() && !faces.empty() && faces.front() >= 0 &&
                  faces.back() < mesh->faceCount() && std::ranges::is_sorted(faces),
              "groups have names and faces");
    claim(mesh->faceCount() > 0 && mesh->vertices.cols() == 3 && mesh->faces.cols() == 3,
          "a mesh has faces");
    claim(mesh->vertices.allFinite() && mesh->vertices.cwiseAbs().maxCoeff() <= 1e6,
          "vertices lie within 1000 km");
    claim(mesh->faces.minCoeff() >= 0 && mesh->faces.maxCoeff() < mesh->vertexCount(),
          "faces have vertices");
    constexpr int slowFaces = 50000; // a small glTF file can repeat its meshes
    if (mesh->faceCount() > slowFaces)
        return;
    claimWritable(*mesh, "again.ply");
    claimWritable(*mesh, "again.obj");
}

} // namespace idiophone::fuzz
