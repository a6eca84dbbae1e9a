// Where each version's golden states and names are (docs/decisions/0026-old-projects.md).
#pragma once

#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace idiophone::test {

inline const std::filesystem::path goldenFolder =
    std::filesystem::path(IDIOPHONE_SOURCE_DIR) / "Tests/Plugin/Golden";

/// Of this version, for what is made anew; made where it is not there. Skips the test unless
/// IDIOPHONE_MAKE_GOLDEN is set.
inline std::filesystem::path folderOfThisVersion() {
    if (std::getenv("IDIOPHONE_MAKE_GOLDEN") == nullptr)
        SKIP("IDIOPHONE_MAKE_GOLDEN is not set");
    const auto folder = goldenFolder / ownEngineVersion();
    std::filesystem::create_directories(folder);
    return folder;
}

inline std::string bytesOf(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

} // namespace idiophone::test
