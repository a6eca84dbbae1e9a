// JSON from files and hosts.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace idiophone {

/// Discarded where the text is not JSON, or nested deeper than anything of ours. nlohmann-json
/// copies and writes by recursion, for which a hostile depth would need more than the stack.
nlohmann::json parseUntrusted(std::string_view text);

} // namespace idiophone
