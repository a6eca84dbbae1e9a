// SPDX-License-Identifier: Apache-2.0
#include "Object/FileBytes.h"

#include <algorithm>
#include <fstream>
#include <new>

namespace idiophone {
namespace {

/// Returns the size in the largest unit that divides it.
std::string sizeText(std::uintmax_t bytes) {
    for (const auto& [shift, unit] : {std::pair{30, " GiB"}, {20, " MiB"}, {10, " KiB"}})
        if (bytes != 0 && bytes % (std::uintmax_t{1} << shift) == 0)
            return std::to_string(bytes >> shift) + unit;
    return std::to_string(bytes) + " bytes";
}

} // namespace

Result<std::string> readBytes(const std::filesystem::path& file, std::uintmax_t limitBytes) {
    std::error_code fault;
    if (std::filesystem::is_directory(file, fault))
        return failure("it is a directory");
    const auto size = std::filesystem::file_size(file, fault);
    std::ifstream stream;
    if (!fault) // opening a pipe, which has no size, would block
        stream.open(file, std::ios::binary);
    if (!stream.is_open())
        return failure("the file cannot be opened");
    if (size > limitBytes)
        return failure("it is larger than " + sizeText(limitBytes));
    try {
        std::string bytes(size, '\0');
        if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
            return failure("the file cannot be read");
        return bytes;
    } catch (const std::bad_alloc&) {
        return failure("it is too large for this machine's memory");
    }
}

std::string nameOf(const std::filesystem::path& file) {
    try {
        const auto name = file.u8string();
        return {name.begin(), name.end()};
    } catch (const std::exception&) {
        return "a file whose name is not Unicode";
    }
}

std::string shownNameOf(const std::filesystem::path& file) {
    return shownName(nameOf(file));
}

std::string storedNameOf(const std::filesystem::path& file) {
    return nameOf(file.generic_string<std::filesystem::path::value_type>());
}

std::filesystem::path pathNamed(std::string_view name) {
    try {
        return std::u8string(name.begin(), name.end());
    } catch (const std::exception&) {
        return {};
    }
}

bool isNetworkName(std::string_view name) {
    const auto isSeparator = [&](std::size_t at) {
        return at < name.size() && (name[at] == '/' || name[at] == '\\');
    };
    return isSeparator(0) && (isSeparator(1) || (name.substr(1, 2) == "??" && isSeparator(3)));
}

bool leadsIntoNetwork(std::string_view name) {
#if defined(_WIN32)
    return isNetworkName(name);
#else
    static_cast<void>(name);
    return false;
#endif
}

std::string localName(std::string_view name) {
    if (leadsIntoNetwork(name))
        name.remove_prefix(std::min(name.find_first_not_of("/\\?"), name.size()));
    return std::string(name);
}

} // namespace idiophone
