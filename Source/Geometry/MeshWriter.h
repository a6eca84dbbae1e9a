// Writes triangle meshes as OBJ or PLY.
#pragma once

#include "Mesh/Mesh.h"
#include "Object/Result.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace idiophone {

/// Writes the mesh in metres. The extension selects the format: .obj, or .ply (as text). Reading
/// the file returns the same doubles.
Result<void> writeMesh(const Mesh& mesh, const std::filesystem::path& file);

/// A value at every vertex and the colour that shows it.
struct VertexFigures {
    std::string name;           ///< name of the PLY property: letters, digits and _
    std::vector<double> values; ///< [N]
    std::vector<std::array<std::uint8_t, 3>> colours; ///< [N] red, green, blue
};

/// Writes the mesh with vertex colours and a scalar property, as PLY only.
Result<void> writeColouredMesh(const Mesh& mesh,
                               const VertexFigures& figures,
                               const std::filesystem::path& file);

} // namespace idiophone
