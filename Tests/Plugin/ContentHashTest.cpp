#include "Plugin/ContentHash.h"

#include <catch2/catch_test_macros.hpp>
#include <string_view>

using namespace idiophone;

namespace {

std::uint64_t hashOf(std::string_view text) {
    return contentHash(std::as_bytes(std::span(text)));
}

} // namespace

TEST_CASE("The hash is the published FNV-1a on every machine") {
    CHECK(hashOf("") == 0xcbf29ce484222325);
    CHECK(hashOf("a") == 0xaf63dc4c8601ec8c);
    CHECK(hashOf("foobar") == 0x85944171f73967e8);
}

TEST_CASE("Data hashed in pieces has the hash of the whole") {
    const std::string_view bar = "bar";
    CHECK(contentHash(std::as_bytes(std::span(bar)), hashOf("foo")) == hashOf("foobar"));
}
