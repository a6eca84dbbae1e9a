// Reads triangle meshes from OBJ, OFF, PLY, STL and glTF files, text and binary. It trusts nothing
// in the file and repairs nothing: see MeshRepair.
#pragma once

#include "Mesh/Mesh.h"
#include "Object/Result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace idiophone {

/// Faces of a mesh that have a name in its file. A face may be in several groups.
struct MeshGroup {
    std::string name;       ///< one line, not empty, unique in the file
    std::vector<int> faces; ///< ascending, not empty

    bool operator==(const MeshGroup&) const = default;
};

struct MeshOfFile {
    Mesh mesh;
    std::string notes; ///< sentences for the user: what is odd in the file; may be empty
    std::vector<MeshGroup> groups = {}; ///< in the file's order, at most `maximumMeshGroups`
    bool isInMetres = false;            ///< the format says so; otherwise the unit is unknown
};

/// Faces of further groups have no name.
inline constexpr std::size_t maximumMeshGroups = 1000;

/// The error says in a sentence which groups there are. The result points into `groups`.
Result<const MeshGroup*> findGroup(const std::vector<MeshGroup>& groups, std::string_view name);

/// Reads a mesh and scales it to metres. The extension selects the format (.obj, .off, .ply, .stl,
/// .gltf, .glb, in upper or lower case).
/// The groups are those of "g" and "o" in OBJ, the solids of a text STL and the nodes of glTF. Axes
/// stay as they are in the file; glTF's y, which points up, becomes z. A glTF file's scene is read
/// with its nodes' places, its buffers from the folder of the file and the folders below. Polygons
/// are cut into triangles inside their outline, or with a note if it crosses itself. A mesh whose
/// faces lie more than a hundred diagonals from the origin is moved there, because objects are
/// stored in single precision. Vertices without a face are kept; those that are no numbers or far
/// away move to a vertex with a face. The error is one sentence with the file and its fault: cannot
/// be opened, empty, truncated or malformed, less content than announced, no faces, a face with a
/// vertex that is not a finite number or does not exist, or faces that reach over more than 10⁶
/// units. Any thread except the audio thread.
Result<MeshOfFile> readMeshFile(const std::filesystem::path& file, double metresPerUnit = 1);

/// Returns whether the extension is one of these.
bool isMeshFile(const std::filesystem::path& file);

/// Does the same, without the notes.
Result<Mesh> readMesh(const std::filesystem::path& file, double metresPerUnit = 1);

} // namespace idiophone
