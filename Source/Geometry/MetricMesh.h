// Reads a mesh file in metres, by its unit or by the size of the mesh.
#pragma once

#include "Geometry/LengthUnit.h"
#include "Geometry/MeshReader.h"
#include "Mesh/Mesh.h"
#include "Object/Result.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

struct MetricMesh {
    Mesh mesh;                ///< in metres
    std::string notes;        ///< of the reader, in sentences
    std::string unitSentence; ///< on the unit, if its guess is uncertain or not metres
    std::vector<MeshGroup> groups;
};

/// `unit` is m, cm, mm, in or ft, or nothing: of the format, else guessed. The error names the file
/// and the fault.
Result<MetricMesh> readMetricMesh(const std::filesystem::path& file,
                                  const std::optional<std::string>& unit);

} // namespace idiophone
