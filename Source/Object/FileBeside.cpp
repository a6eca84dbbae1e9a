#include "Object/FileBeside.h"

#include <cstdio>
#include <string>

namespace idiophone {
namespace {

constexpr int mostNames = 1000;

/// Not where there is a file: it may be somebody's, such as what a browser has not got all of.
bool makeNewFile(const std::filesystem::path& file) {
#ifdef _WIN32
    auto* const stream = _wfopen(file.c_str(), L"wbx");
#else
    auto* const stream = std::fopen(file.c_str(), "wbx");
#endif
    return stream != nullptr && std::fclose(stream) == 0;
}

} // namespace

std::optional<std::filesystem::path> makeFileBeside(const std::filesystem::path& file) {
    std::error_code ignored;
    for (int number = 1; number <= mostNames; ++number) {
        auto beside = file;
        beside += "." + std::to_string(number) + ".part";
        if (makeNewFile(beside))
            return beside;
        if (!std::filesystem::exists(std::filesystem::symlink_status(beside, ignored)))
            break;
    }
    return std::nullopt;
}

} // namespace idiophone
