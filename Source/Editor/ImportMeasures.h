// Texts of lengths and masses of imported objects, and what is typed for them.
#pragma once

#include "Editor/FigureText.h"
#include "Parameters/Units.h"

#include <algorithm>
#include <array>
#include <juce_core/juce_core.h>
#include <optional>

namespace idiophone {

/// "2 mm".
inline juce::String thicknessText(double metres) {
    return juce::String(juce::String(1000 * metres, 3).getDoubleValue()) + " mm";
}

/// "12.5 cm".
inline juce::String sizeText(double metres) {
    return figureText(100 * metres) + " cm";
}

/// "340 g", "32.7 kg".
inline juce::String massText(double massKg) {
    return massKg < 1 ? figureText(1000 * massKg) + " g" : figureText(massKg) + " kg";
}

/// "30 x 12 x 0.4 cm".
inline juce::String sidesText(const std::array<double, 3>& sidesMetres) {
    juce::StringArray sides;
    for (const double side : sidesMetres)
        sides.add(figureText(100 * side));
    return sides.joinIntoString(" x ") + " cm";
}

/// "30 x 12 x 0.4 cm, 340 g"; empty for an object without extent.
inline juce::String measuresText(const std::array<double, 3>& sidesMetres, double massKg) {
    if (!(*std::ranges::max_element(sidesMetres) > 0))
        return {};
    return sidesText(sidesMetres) + ", " + massText(massKg);
}

/// Parses a length in any unit, or in `plainUnit` if there is none. Returns nothing unless it is a
/// number from `minimum` to `maximum` in metres.
inline std::optional<double>
parseLengthMetres(const juce::String& text, const char* plainUnit, double minimum, double maximum) {
    const auto typed = parseTypedNumber(text.toStdString());
    if (!typed)
        return std::nullopt;
    const auto metres = inUnit(typed->number, typed->unit.empty() ? plainUnit : typed->unit, "m");
    return metres && *metres >= minimum && *metres <= maximum ? metres : std::nullopt;
}

/// A thickness from 0.01 mm to 1 m, in mm if there is no unit.
inline std::optional<double> parseThicknessMetres(const juce::String& text) {
    return parseLengthMetres(text, "mm", 1e-5, 1);
}

/// A size from 1 mm to 20 m, in cm if there is no unit.
inline std::optional<double> parseSizeMetres(const juce::String& text) {
    return parseLengthMetres(text, "cm", 1e-3, 20);
}

} // namespace idiophone
