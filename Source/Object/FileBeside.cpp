#include "Object/FileBeside.h"

#include <cstdio>
#include <fstream>
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

bool isProtected(const std::filesystem::path& file) {
    using std::filesystem::perms;
    std::error_code ignored;
    const auto there = std::filesystem::status(file, ignored);
    return std::filesystem::is_regular_file(there) &&
           (there.permissions() &
            (perms::owner_write | perms::group_write | perms::others_write)) == perms::none;
}

bool fill(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write) {
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    write(stream);
    stream.close();
    return !stream.fail();
}

} // namespace

std::optional<std::filesystem::path> makeFileBeside(const std::filesystem::path& file) {
    if (isProtected(file))
        return std::nullopt;
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

std::filesystem::path behindLinks(const std::filesystem::path& file) {
    std::error_code fault;
    auto place = std::filesystem::canonical(file, fault);
    return fault ? file : place;
}

bool replaceFile(const std::filesystem::path& file,
                 const std::function<void(std::ostream&)>& write) {
    std::error_code fault;
    const auto kind = std::filesystem::status(file, fault).type();
    if (kind != std::filesystem::file_type::regular &&
        kind != std::filesystem::file_type::not_found)
        return fill(file, write);
    const auto place = behindLinks(file);
    const auto beside = makeFileBeside(place);
    if (!beside)
        return false;
    const bool isComplete = fill(*beside, write);
    if (kind == std::filesystem::file_type::regular)
        std::filesystem::permissions(*beside, std::filesystem::status(place, fault).permissions(),
                                     fault);
    fault.clear(); // there are disks without permissions
    if (isComplete)
        std::filesystem::rename(*beside, place, fault);
    if (!isComplete || fault) {
        std::filesystem::remove(*beside, fault);
        return false;
    }
    return true;
}

} // namespace idiophone
