// JSON as the console says it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace idiophone {

/// Indented, with a line end. Names come from people and files: what is not UTF-8 is replaced.
inline std::string jsonText(const nlohmann::ordered_json& value) {
    return value.dump(4, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace idiophone
