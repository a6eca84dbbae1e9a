#include "Plugin/ImportSummary.h"

#include "Editor/Utf8.h"
#include "Instrument/ObjectBox.h"
#include "Object/ModalObjectFile.h"
#include "Object/OneLine.h"
#include "Plugin/ContentHash.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace idiophone {
namespace {

/// Formats a value to three significant digits.
juce::String figure(double value) {
    if (value >= 100)
        return juce::String(juce::roundToInt(value));
    if (value < 0.0005)
        return "0";
    return juce::String(value, value >= 10 ? 1 : value >= 1 ? 2 : 3);
}

juce::String frequency(double hz) {
    return hz < 1000 ? figure(hz) + " Hz" : figure(hz / 1000) + " kHz";
}

} // namespace

std::string summaryOf(const ModalObject& object) {
    const double lowestHz = std::sqrt(object.eigenvalues.front()) / (2 * std::numbers::pi);
    const auto sides = sidesMetresOf(object);
    const auto millimetres = [&](std::size_t axis) { return figure(1000 * sides[axis]); };
    const double kilograms = object.mass.massKg;
    const auto modes = static_cast<int>(object.modeCount());
    return (juce::String(modes) + (modes == 1 ? " mode at " : " modes from ") +
            frequency(lowestHz) +
            (modes == 1 ? juce::String() : " to " + frequency(object.bandHz)) + "; " +
            (kilograms < 1 ? figure(1000 * kilograms) + " g" : figure(kilograms) + " kg") + " of " +
            fromUtf8(object.material.name) + ", " + millimetres(0) + " x " + millimetres(1) +
            " x " + millimetres(2) + " mm")
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

std::string uniqueName(const ModalObject& object) {
    const auto hash = static_cast<juce::int64>(contentHash(encodeModalObject(object)));
    return "imported/" + oneLine(object.name) + "-" + juce::String::toHexString(hash).toStdString();
}

} // namespace idiophone
