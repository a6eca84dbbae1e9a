// Triangle meshes from files: OBJ, OFF, PLY and STL, text and binary. The reader trusts nothing in
// the file and repairs nothing: see MeshRepair for that.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/Result.h"

#include <filesystem>

namespace idiophone {

/// The mesh of a file in metres, polygons cut into fans of triangles. The extension says the format
/// (.obj, .off, .ply, .stl, in any case). Vertices that no face names are kept.
/// The error is one sentence that names the file and the fault: it cannot be opened, is empty,
/// truncated or malformed, promises more than it holds, has no faces, a vertex that is not a finite
/// number, or a face with a vertex that does not exist. Any thread; not for the audio thread.
Result<Mesh> readMesh(const std::filesystem::path& file, double metresPerUnit = 1);

} // namespace idiophone
