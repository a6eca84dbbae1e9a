// The vibration models for a mesh, and their names.
#pragma once

#include <optional>
#include <string_view>

namespace idiophone {

enum class AnalysisMethod {
    tetrahedra, ///< finite elements, for solids
    twoLayer,   ///< two layers of springs over the thickness, for shells
    springMass, ///< springs with k = Y t, as published
    vanGelder   ///< springs with k = Y t (A1 + A2)/L²
};

/// Returns "fem", "two-layer", "spring-mass" or "van-gelder", the names in object files and in the
/// console.
std::string_view methodName(AnalysisMethod method);
std::optional<AnalysisMethod> findMethod(std::string_view name);

} // namespace idiophone
