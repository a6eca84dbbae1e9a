// Which model suits a mesh: tetrahedra for closed and chunky bodies, a shell for what is thin or
// open.
#pragma once

#include "Analysis/AnalysisMethod.h"
#include "Geometry/MeshCheck.h"

#include <string>

namespace idiophone {

struct MethodChoice {
    AnalysisMethod method = AnalysisMethod::twoLayer;
    std::string reason; ///< a sentence that says which and why
};

MethodChoice chooseMethod(const MeshCheck& check, double shellThicknessMetres);

/// For a body that tetrahedra did not fill, whatever its check had said. `why` is a sentence.
MethodChoice shellInstead(const std::string& why, double shellThicknessMetres);

/// "it has 12 boundary edges": what keeps tetrahedra from filling a mesh that is not solid.
std::string whyNotSolid(const MeshCheck& check);

} // namespace idiophone
