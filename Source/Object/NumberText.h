// SPDX-License-Identifier: Apache-2.0
// Converts numbers in text files and sentences, identically in every locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace idiophone {

/// Parses a whole word as a number. Accepts "nan" and "inf", which the caller must refuse.
std::optional<double> parseNumber(std::string_view word);
std::optional<std::int64_t> parseInteger(std::string_view word);

/// Returns the value with `digits` significant digits, without trailing zeros: "0.25", "-1e-09",
/// "nan".
std::string numberText(double value, int digits = 6);

} // namespace idiophone
