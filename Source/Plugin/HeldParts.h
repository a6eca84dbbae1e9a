// The support of a mesh that the settings of an import mean.
#pragma once

#include "Analysis/Clamp.h"
#include "Editor/HeldSettings.h"
#include "Geometry/MeshReader.h"

#include <vector>

namespace idiophone {

/// The parts of a mesh that can be held by name.
struct HoldableParts {
    std::vector<MeshGroup> groups = {};
    std::vector<int> clampedVertices = {}; ///< of the object that the mesh is from, if it was held
};

/// Returns the names of the groups that do not have all faces of the mesh.
std::vector<std::string> namesOfGroups(const HoldableParts& parts, const Mesh& mesh);

/// Error, one sentence: the mesh has no such group, or the support's quality factor is negative.
Result<Support>
supportOf(const HeldSettings& held, const HoldableParts& parts, const Mesh& meshMetres);

} // namespace idiophone
