#include "Object/UntrustedJson.h"

#include <algorithm>

namespace idiophone {

using nlohmann::json;

namespace {

/// Takes everything and remembers where it went wrong.
struct FaultFinder : nlohmann::json_sax<json> {
    std::optional<std::size_t> bytesRead;

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_object(std::size_t) override { return true; }
    bool key(string_t&) override { return true; }
    bool end_object() override { return true; }
    bool start_array(std::size_t) override { return true; }
    bool end_array() override { return true; }
    bool parse_error(std::size_t position, const std::string&, const json::exception&) override {
        bytesRead = position;
        return false;
    }
};

} // namespace

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

std::optional<std::size_t> firstByteNotJson(std::string_view text) {
    FaultFinder finder;
    json::sax_parse(text, &finder);
    if (!finder.bytesRead)
        return std::nullopt;
    return std::min(text.size(), *finder.bytesRead == 0 ? 0 : *finder.bytesRead - 1);
}

std::string placeOfJsonFault(std::string_view text) {
    const auto fault = firstByteNotJson(text);
    if (!fault)
        return {};
    const auto before = text.substr(0, *fault);
    const auto line = 1 + std::ranges::count(before, '\n');
    const auto lineStart = before.rfind('\n') + 1; // 0 where there is none
    return " (line " + std::to_string(line) + ", column " +
           std::to_string(before.size() - lineStart + 1) + ")";
}

} // namespace idiophone
