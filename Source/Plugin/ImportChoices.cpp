#include "Plugin/ImportChoices.h"

#include "Object/MaterialFile.h"

#include <utility>

namespace idiophone {
namespace {

UnitGuess givenUnit(const Mesh& mesh, UnitSource source, const ImportSettings& settings) {
    if (source == UnitSource::object)
        return {.unit = *lengthUnitNamed("m"), .isSure = true, .sentence = {}};
    if (const auto named = lengthUnitNamed(settings.unit))
        return {.unit = *named, .isSure = true, .sentence = {}};
    return guessLengthUnit(mesh, source == UnitSource::format);
}

} // namespace

UnitGuess unitOf(const Mesh& mesh, UnitSource source, const ImportSettings& settings) {
    auto unit = givenUnit(mesh, source, settings);
    if (settings.longestMetres == 0 || mesh.faceCount() == 0)
        return unit;
    const double longest = boxOfFaces(mesh).sizes().maxCoeff();
    if (longest > 0) {
        unit.unit.metresPerUnit = settings.longestMetres / longest;
        unit.sentence =
            "Scaled to a longest side of " + millimetresText(settings.longestMetres) + ".";
    }
    return unit;
}

Result<ImportChoices> choicesOf(const ImportSettings& settings) {
    if (!(settings.thicknessMetres >= 1e-5 && settings.thicknessMetres <= 1))
        return failure("The thickness must be between 0.01 mm and 1 m.");
    if (settings.longestMetres != 0 &&
        !(settings.longestMetres >= 1e-3 && settings.longestMetres <= 20))
        return failure("The longest side must be between 1 mm and 20 m.");
    if (!settings.unit.empty() && !lengthUnitNamed(settings.unit))
        return failure("There is no unit '" + settings.unit + "'.");
    const auto method = findMethod(settings.method);
    if (!method && !settings.method.empty())
        return failure("There is no method '" + settings.method + "'.");
    auto material = findAnyMaterial(settings.material);
    if (!material)
        return tl::unexpected(material.error());
    return ImportChoices{.material = std::move(*material), .method = method};
}

} // namespace idiophone
