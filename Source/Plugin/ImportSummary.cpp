#include "Plugin/ImportSummary.h"

#include "Editor/ImportMeasures.h"
#include "Editor/ModeText.h"
#include "Editor/Utf8.h"
#include "Instrument/ObjectBox.h"
#include "Object/ModalObjectFile.h"
#include "Object/OneLine.h"
#include "Plugin/ContentHash.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace idiophone {
std::string summaryOf(const ModalObject& object) {
    const double lowestHz = std::sqrt(object.eigenvalues.front()) / (2 * std::numbers::pi);
    const auto sides = sidesMetresOf(object);
    const auto millimetres = [&](std::size_t axis) { return figureText(1000 * sides[axis]); };
    const auto modes = static_cast<int>(object.modeCount());
    return (juce::String(modes) + (modes == 1 ? " mode at " : " modes from ") +
            frequencyText(lowestHz) +
            (modes == 1 ? juce::String() : " to " + frequencyText(object.bandHz)) + "; " +
            massText(object.mass.massKg) + " of " + fromUtf8(object.material.name) + ", " +
            millimetres(0) + " x " + millimetres(1) + " x " + millimetres(2) + " mm")
        .toStdString();
}

std::array<double, 3> sidesMetresOf(const ModalObject& object) {
    auto sides = ObjectBox(object).halfExtentMetres;
    for (double& side : sides)
        side *= 2;
    return sides;
}

std::string notesOf(const ModalObject& object, const std::string& unitSentence) {
    const auto& notes = object.provenance.notes;
    return unitSentence + (unitSentence.empty() || notes.empty() ? "" : " ") + notes;
}

std::string materialNameOf(const ModalObject& object, const ParameterValues& values) {
    const auto chosen = static_cast<std::size_t>(values[ParameterId::material]);
    const auto names = choiceNames(ParameterId::material);
    return chosen >= firstLibraryMaterial && chosen < names.size() ? std::string(names[chosen])
                                                                   : object.material.name;
}

std::optional<double> thicknessMetresOf(const ModalObject& object, const ParameterValues& values) {
    if (!(object.thicknessMetres > 0))
        return std::nullopt;
    return object.thicknessMetres * values[ParameterId::thickness] / 100;
}

std::string uniqueName(const ModalObject& object) {
    const auto hash = static_cast<juce::int64>(contentHash(encodeModalObject(object)));
    return "imported/" + oneLine(object.name) + "-" + juce::String::toHexString(hash).toStdString();
}

} // namespace idiophone
