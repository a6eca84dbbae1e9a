// SPDX-License-Identifier: Apache-2.0
#include "Object/TextFile.h"

#include "Object/FileBeside.h"
#include "Object/FileBytes.h"

namespace idiophone {

Result<std::string> readTextFile(const std::filesystem::path& file, std::uintmax_t limitBytes) {
    return readBytes(file, limitBytes).map_error([&](const Error& fault) {
        return Error{shownNameOf(file) + ": " + fault.message};
    });
}

Result<void> writeTextFile(const std::filesystem::path& file, const std::string& text) {
    if (!replaceFile(file, [&](std::ostream& stream) { stream << text; }))
        return failure(shownNameOf(file) + ": the file cannot be written");
    return {};
}

} // namespace idiophone
