#include "Object/UntrustedJson.h"

namespace idiophone {

using nlohmann::json;

json parseUntrusted(std::string_view text) {
    constexpr int deepest = 64;
    bool isTooDeep = false;
    const auto keepIfShallow = [&](int depth, json::parse_event_t, json&) {
        isTooDeep = isTooDeep || depth > deepest;
        return !isTooDeep;
    };
    auto root = json::parse(text, keepIfShallow, false);
    return isTooDeep ? json(json::value_t::discarded) : root;
}

} // namespace idiophone
