// SPDX-License-Identifier: Apache-2.0
#include "Object/FileBeside.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#include <share.h>
#include <sys/stat.h>
#endif

namespace idiophone {
namespace {

constexpr int maximumNames = 1000;

/// Fails if the file exists: it may belong to another program, for example an unfinished download.
bool makeNewFile(const std::filesystem::path& file) {
#ifdef _WIN32
    int number = 0; // older libraries of Windows ignore the x of fopen
    return _wsopen_s(&number, file.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL, _SH_DENYNO,
                     _S_IREAD | _S_IWRITE) == 0 &&
           _close(number) == 0;
#else
    auto* const stream = std::fopen(file.c_str(), "wbx");
    return stream != nullptr && std::fclose(stream) == 0;
#endif
}

/// Returns whether the file is write-protected or a link to itself.
bool isProtected(const std::filesystem::path& file) {
    using std::filesystem::perms;
    std::error_code fault;
    const auto there = std::filesystem::status(file, fault);
    if (fault == std::errc::too_many_symbolic_link_levels)
        return true;
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

/// Returns whether the unit continues a character of UTF-8 or, on Windows, UTF-16.
constexpr bool continues(std::filesystem::path::value_type unit) {
    return sizeof unit == 1 ? (unit & 0xc0) == 0x80 : (unit & 0xfc00) == 0xdc00;
}

/// Returns the file's name with an ending. A long name is cut and does not become longer: file
/// systems limit the name, and Windows the whole path.
std::filesystem::path withEnding(const std::filesystem::path& file, const std::string& ending) {
    constexpr std::size_t shortName = 40;
    auto name = file.filename().native();
    if (auto length = std::max(name.size(), shortName) - ending.size(); name.size() > length) {
        while (length > 0 && continues(name[length]))
            --length;
        name.resize(length);
    }
    return file.parent_path() / std::filesystem::path(name).concat(ending);
}

} // namespace

std::optional<std::filesystem::path> makeFileBeside(const std::filesystem::path& file) {
    if (isProtected(file))
        return std::nullopt;
    std::error_code ignored;
    for (int number = 1; number <= maximumNames; ++number) {
        const auto beside = withEnding(file, "." + std::to_string(number) + ".part");
        if (makeNewFile(beside))
            return beside;
        if (!std::filesystem::exists(std::filesystem::symlink_status(beside, ignored)))
            break;
    }
    return std::nullopt;
}

std::filesystem::path behindLinks(const std::filesystem::path& file) {
    std::error_code fault;
    if (auto place = std::filesystem::canonical(file, fault); !fault)
        return place;
    auto place = file;
    constexpr int maximumLinks = 40;
    for (int links = 0; links < maximumLinks; ++links) {
        const auto target = std::filesystem::read_symlink(place, fault);
        if (fault)
            return place;
        place = place.parent_path() / target;
    }
    return file;
}

bool putInPlace(const std::filesystem::path& beside, const std::filesystem::path& file) {
    std::error_code fault; // some file systems have no permissions
    if (const auto there = std::filesystem::status(file, fault);
        std::filesystem::is_regular_file(there))
        std::filesystem::permissions(beside, there.permissions(), fault);
    std::filesystem::rename(beside, file, fault);
    return !fault;
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
    if (fill(*beside, write) && putInPlace(*beside, place))
        return true;
    std::filesystem::remove(*beside, fault);
    return false;
}

} // namespace idiophone
