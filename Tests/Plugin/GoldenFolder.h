// Where each version's golden states and names are (docs/decisions/0026-old-projects.md).
#pragma once

#include "Support/TestSound.h"

#include <array>
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

/// A way in which states are played and what is kept of it, as NAME and this ending.
struct GoldenTake {
    const char* ending;
    double rateHz;
    int samples;
    int keptOf; ///< of so many blocks the last one is kept
    int least;  ///< that each version has
};
inline constexpr int goldenBlockSize = 256;
/// All states at a low rate, and some of them as they are mostly played, above 11 kHz and for long.
inline constexpr std::array goldenTakes{GoldenTake{".wav", 22050, 22050, 1, 12},
                                        GoldenTake{"-48k.wav", 48000, 22050, 2, 3},
                                        GoldenTake{"-5s.wav", 48000, 240000, 16, 1}};

inline std::filesystem::path waveOf(const std::filesystem::path& state, const GoldenTake& take) {
    return state.parent_path() / (state.stem().string() + take.ending);
}

inline std::string bytesOf(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

} // namespace idiophone::test
