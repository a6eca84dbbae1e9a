// JSON from files and hosts.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace idiophone {

/// Discarded where the text is not JSON, or nested deeper than anything of ours. nlohmann-json
/// copies and writes by recursion, for which a hostile depth would need more than the stack.
nlohmann::json parseUntrusted(std::string_view text);

/// Where a text stops being JSON, to end a sentence with: " (line 3, column 7)"; empty where it is
/// JSON, as what is nested too deep may be.
std::string placeOfJsonFault(std::string_view text);

} // namespace idiophone
