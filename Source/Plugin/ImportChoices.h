// Checks the settings of an import, and what they name.
#pragma once

#include "Analysis/AnalysisMethod.h"
#include "Editor/WorkshopView.h"
#include "Geometry/LengthUnit.h"
#include "Object/Material.h"
#include "Object/Result.h"

#include <optional>

namespace idiophone {

struct ImportChoices {
    Material material;
    std::optional<AnalysisMethod> method; ///< empty: chosen for the mesh
};

/// How the unit of a mesh is known.
enum class UnitSource {
    object,  ///< it is in metres
    format,  ///< it is in metres unless the settings name a unit
    unknown, ///< the settings name it, or it is guessed
};

/// Returns the unit of the mesh. If the settings give the longest side, `metresPerUnit` scales the
/// mesh to it.
UnitGuess unitOf(const Mesh& mesh, UnitSource source, const ImportSettings& settings);

/// Error, one sentence: a setting is out of range or names nothing.
Result<ImportChoices> choicesOf(const ImportSettings& settings);

} // namespace idiophone
