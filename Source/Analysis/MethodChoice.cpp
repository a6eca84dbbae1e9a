#include "Analysis/MethodChoice.h"

#include "Geometry/LengthUnit.h"

#include <array>
#include <utility>

namespace idiophone {
namespace {

constexpr std::array<std::pair<AnalysisMethod, std::string_view>, 4> methodNames{
    {{AnalysisMethod::tetrahedra, "fem"},
     {AnalysisMethod::twoLayer, "two-layer"},
     {AnalysisMethod::springMass, "spring-mass"},
     {AnalysisMethod::vanGelder, "van-gelder"}}};

std::string shellOf(double thicknessMetres) {
    return "Taken as a shell of " + millimetresText(thicknessMetres);
}

} // namespace

std::string_view methodName(AnalysisMethod method) {
    for (const auto& [each, name] : methodNames)
        if (each == method)
            return name;
    return {};
}

std::optional<AnalysisMethod> findMethod(std::string_view name) {
    for (const auto& [method, each] : methodNames)
        if (each == name)
            return method;
    return std::nullopt;
}

std::string whyNotSolid(const MeshCheck& check) {
    if (check.boundaryEdges > 0)
        return "its surface is open";
    if (check.nonManifoldEdges > 0)
        return "more than two faces meet at some of its edges";
    if (!check.isOriented)
        return "it has no clear inside and outside";
    if (!check.intersectsItself)
        return "it is too tangled to tell whether it passes through itself";
    if (*check.intersectsItself)
        return "it passes through itself";
    return "it encloses no volume";
}

MethodChoice shellInstead(const std::string& why, double shellThicknessMetres) {
    return {AnalysisMethod::twoLayer,
            shellOf(shellThicknessMetres) + ", because it cannot be taken as a solid: " + why};
}

MethodChoice chooseMethod(const MeshCheck& check, double shellThicknessMetres) {
    const std::string shell = shellOf(shellThicknessMetres) + ", because ";
    if (!check.isSolid())
        return {AnalysisMethod::twoLayer, shell + whyNotSolid(check) + "."};
    if (check.isThin())
        return {AnalysisMethod::twoLayer,
                shell + "its walls are thin, " + millimetresText(check.meanThicknessMetres) +
                    " on average; a mesh of the middle of its walls, with that thickness, "
                    "would be nearer the truth."};
    return {AnalysisMethod::tetrahedra, "Taken as a solid, because it is closed and thick."};
}

} // namespace idiophone
