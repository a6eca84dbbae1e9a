// The models that a mesh can be analysed with, and their names.
#pragma once

#include <optional>
#include <string_view>

namespace idiophone {

enum class AnalysisMethod {
    tetrahedra, ///< finite elements, for solids
    twoLayer,   ///< two layers of springs over the thickness, for shells
    springMass, ///< as published, k = Y t
    vanGelder   ///< the same with k = Y t (A1 + A2)/L²
};

/// "fem", "two-layer", "spring-mass", "van-gelder": as objects and the console name them.
std::string_view methodName(AnalysisMethod method);
std::optional<AnalysisMethod> findMethod(std::string_view name);

} // namespace idiophone
