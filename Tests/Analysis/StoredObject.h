// Reads the factory's objects as they are stored.
#pragma once

#include "Object/ModalObjectFile.h"

#include <catch2/catch_test_macros.hpp>
#include <filesystem>
#include <string>
#include <utility>

namespace idiophone::test {

inline std::filesystem::path storedObjects() {
    return std::filesystem::path(IDIOPHONE_SOURCE_DIR) / "Resources" / "Objects";
}

inline ModalObject stored(const std::string& name) {
    auto object = readModalObject(storedObjects() / (name + ".modal"));
    INFO(name);
    REQUIRE(object);
    CHECK(object->name == name);
    return std::move(*object);
}

} // namespace idiophone::test
