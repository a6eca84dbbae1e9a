// JSON from files and hosts.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace idiophone {

/// Discarded where the text is not JSON, or nested deeper than anything of ours. nlohmann-json
/// copies and writes by recursion, for which a hostile depth would need more than the stack.
nlohmann::json parseUntrusted(std::string_view text);

/// The byte with which a text stops being JSON, its size where it ends too early; nothing where it
/// is JSON, as what is nested too deep may be.
std::optional<std::size_t> firstByteNotJson(std::string_view text);

/// The same to end a sentence with: " (line 3, column 7)"; empty where it is JSON.
std::string placeOfJsonFault(std::string_view text);

} // namespace idiophone
