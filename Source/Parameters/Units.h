// Units as people type them: converts a number between two units of one quantity.
#pragma once

#include <optional>
#include <string_view>

namespace idiophone {

/// Returns the number in the unit `wanted`, or nothing if the two do not measure the same. An empty
/// unit is a pure number, which "%" and "×" measure too. Any keyboard can type a unit: "kg/m3",
/// "kg/m^3", "us" and "x" stand for "kg/m³", "µs" and "×", and capital letters do not matter.
std::optional<double> inUnit(double number, std::string_view typed, std::string_view wanted);

} // namespace idiophone
