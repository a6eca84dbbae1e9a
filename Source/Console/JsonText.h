// Formats JSON for the console.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace idiophone {

/// Indents the text and ends it with a line end. Names come from people and files: invalid UTF-8 is
/// replaced.
inline std::string jsonText(const nlohmann::ordered_json& value) {
    return value.dump(4, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace idiophone
