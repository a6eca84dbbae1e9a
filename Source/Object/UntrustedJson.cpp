// SPDX-License-Identifier: Apache-2.0
#include "Object/UntrustedJson.h"

#include <algorithm>
#include <limits>

namespace idiophone {

using nlohmann::json;

namespace {

/// Accepts everything down to a depth, and records the position of an error.
struct FaultFinder : nlohmann::json_sax<json> {
    std::size_t deepest = std::numeric_limits<std::size_t>::max();
    std::size_t depth = 0;
    std::optional<std::size_t> bytesRead;

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_object(std::size_t) override { return ++depth <= deepest; }
    bool key(string_t&) override { return true; }
    bool end_object() override { return leave(); }
    bool start_array(std::size_t) override { return ++depth <= deepest; }
    bool end_array() override { return leave(); }
    bool parse_error(std::size_t position, const std::string&, const json::exception&) override {
        bytesRead = position;
        return false;
    }

private:
    bool leave() {
        --depth;
        return true;
    }
};

} // namespace

json parseUntrusted(std::string_view text) {
    // Checks the depth in a separate pass. With a callback, the parser searches a whole array at
    // the end of each object in it, which takes quadratic time.
    FaultFinder finder;
    finder.deepest = 64;
    if (!json::sax_parse(text, &finder))
        return json(json::value_t::discarded); // parentheses, because braces would make a list
    return json::parse(text, nullptr, false);
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
    const auto lineStart = before.rfind('\n') + 1; // 0 in the first line
    return " (line " + std::to_string(line) + ", column " +
           std::to_string(before.size() - lineStart + 1) + ")";
}

} // namespace idiophone
