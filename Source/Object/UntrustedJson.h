// SPDX-License-Identifier: Apache-2.0
// Parses JSON from files and hosts.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace idiophone {

/// Returns a discarded value if the text is not JSON or is nested deeper than any file of
/// Idiophone. nlohmann-json copies and writes recursively, so a hostile depth would overflow the
/// stack.
nlohmann::json parseUntrusted(std::string_view text);

/// Returns the first byte that is not JSON, or the size if the text ends too early. Returns nothing
/// for JSON, even if it is nested too deeply.
std::optional<std::size_t> firstByteNotJson(std::string_view text);

/// Returns the place of `firstByteNotJson` as the end of a sentence: " (line 3, column 7)". Empty
/// for JSON.
std::string placeOfJsonFault(std::string_view text);

} // namespace idiophone
