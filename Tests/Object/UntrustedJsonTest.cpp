#include "Object/UntrustedJson.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

namespace {

std::string nested(std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
}

} // namespace

TEST_CASE("JSON of normal depth is parsed unchanged") {
    const auto root = parseUntrusted(R"({"a": [1, {"b": "ü"}], "c": null})");
    CHECK(root == nlohmann::json{{"a", {1, {{"b", "ü"}}}}, {"c", nullptr}});
    CHECK(parseUntrusted(nested(64)).is_array());
    CHECK(parseUntrusted(nested(64)).dump() == nested(64));
}

TEST_CASE("The first byte that is not JSON is found with its line and column") {
    CHECK(firstByteNotJson("{\n\"a\": x}") == 7);
    CHECK(placeOfJsonFault("{\n\"a\": x}") == " (line 2, column 6)");
    CHECK(firstByteNotJson("[1, 2") == 5);
    CHECK(firstByteNotJson("") == 0);
    CHECK(firstByteNotJson("[1, 2]") == std::nullopt);
    CHECK(placeOfJsonFault("[1, 2]").empty());
}

TEST_CASE("Invalid or too deeply nested JSON is discarded") {
    CHECK(parseUntrusted("").is_discarded());
    CHECK(parseUntrusted("{").is_discarded());
    CHECK(parseUntrusted("[1e999]").is_discarded());
    CHECK(parseUntrusted("\"\xff\"").is_discarded());
    CHECK(parseUntrusted(nested(65)).is_discarded());
    CHECK(parseUntrusted(nested(1000000)).is_discarded());
    CHECK(parseUntrusted(R"({"a": 1, "b": )" + nested(1000000) + "}").is_discarded());
    CHECK(parseUntrusted(std::string(1000000, '[')).is_discarded());
}

TEST_CASE("A list of many objects is parsed in linear time") {
    constexpr std::size_t count = 1'000'000; // quadratic time would take hours
    std::string text = "[{}";
    for (std::size_t k = 1; k < count; ++k)
        text += ",{}";
    CHECK(parseUntrusted(text + "]").size() == count);
    CHECK(firstByteNotJson(text) == text.size());
}
