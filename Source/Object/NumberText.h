// Numbers in text files and sentences, the same in every locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace idiophone {

/// A whole word as a number ("nan" and "inf" are numbers, to be refused by what they mean).
std::optional<double> parseNumber(std::string_view word);
std::optional<std::int64_t> parseInteger(std::string_view word);

/// The value to so many significant digits, without trailing zeros: "0.25", "-1e-09", "nan".
std::string numberText(double value, int digits = 6);

} // namespace idiophone
