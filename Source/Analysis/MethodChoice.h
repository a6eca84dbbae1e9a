// Chooses the model for a mesh: tetrahedra for closed, thick bodies, a shell for thin or open ones.
#pragma once

#include "Analysis/AnalysisMethod.h"
#include "Geometry/MeshCheck.h"

#include <string>

namespace idiophone {

struct MethodChoice {
    AnalysisMethod method = AnalysisMethod::twoLayer;
    std::string reason; ///< a sentence that names the choice and its reason
};

MethodChoice chooseMethod(const MeshCheck& check, double shellThicknessMetres);

/// The choice after tetrahedra could not fill a body. `why` is a sentence.
MethodChoice shellInstead(const std::string& why, double shellThicknessMetres);

/// Says why tetrahedra cannot fill a mesh that is not solid: "its surface is open".
std::string whyNotSolid(const MeshCheck& check);

} // namespace idiophone
