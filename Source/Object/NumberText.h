// Numbers in text files, the same in every locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace idiophone {

/// A whole word as a number ("nan" and "inf" are numbers, to be refused by what they mean).
std::optional<double> parseNumber(std::string_view word);
std::optional<std::int64_t> parseInteger(std::string_view word);

} // namespace idiophone
