// Writes triangle meshes as OBJ or PLY, for people and other programs.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/Result.h"

#include <filesystem>

namespace idiophone {

/// Writes the mesh in metres; the extension (.obj or .ply, the latter as text) says the format.
/// Numbers are written so that reading gives the same doubles back.
Result<void> writeMesh(const Mesh& mesh, const std::filesystem::path& file);

} // namespace idiophone
