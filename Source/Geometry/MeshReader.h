// Reads triangle meshes from OBJ, OFF, PLY and STL files, text and binary. It trusts nothing in the
// file and repairs nothing: see MeshRepair.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/Result.h"

#include <filesystem>

namespace idiophone {

/// Reads a mesh and scales it to metres. Polygons become fans of triangles. The extension selects
/// the format (.obj, .off, .ply, .stl, in upper or lower case). Vertices without a face are kept.
/// The error is one sentence with the file and its fault: cannot be opened, empty, truncated or
/// malformed, less content than announced, no faces, a vertex that is not a finite number, or a
/// face with a vertex that does not exist. Any thread except the audio thread.
Result<Mesh> readMesh(const std::filesystem::path& file, double metresPerUnit = 1);

} // namespace idiophone
