// Numbers and units as people type them: parses them, and converts between units of one quantity.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace idiophone {

struct TypedNumber {
    double number = 0;
    std::string unit = {}; ///< without spaces around it; empty if there is none
};

/// Parses "7.85 kg/l" or "7,85 kg/l": a comma stands for the decimal point, in every locale.
/// Returns nothing if the text does not start with a number.
std::optional<TypedNumber> parseTypedNumber(std::string_view text);

/// Returns the number in the unit `wanted`, or nothing if the two do not measure the same. An empty
/// unit is a pure number, which "%" and "×" measure too. Any keyboard can type a unit: "kg/m3",
/// "kg/m^3", "us" and "x" stand for "kg/m³", "µs" and "×", and capital letters do not matter.
std::optional<double> inUnit(double number, std::string_view typed, std::string_view wanted);

} // namespace idiophone
