// Texts of positive numbers with three significant digits.
#pragma once

#include <juce_core/juce_core.h>

namespace idiophone {

/// Three significant digits, but at most three decimals, and all digits before the point: "2.30",
/// "12.5", "1447", "0.040".
inline juce::String threeDigits(double value) {
    const int decimals = value < 0.9995 ? 3 : value < 9.995 ? 2 : value < 99.95 ? 1 : 0;
    // juce::String reads 0 decimals as "all decimals".
    return decimals > 0 ? juce::String(value, decimals) : juce::String(juce::roundToInt(value));
}

/// The same without zeros at the end: "2.3", "0.04".
inline juce::String figureText(double value) {
    const auto digits = threeDigits(value);
    return digits.containsChar('.') ? juce::String(digits.getDoubleValue()) : digits;
}

} // namespace idiophone
