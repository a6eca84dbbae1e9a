#include "Object/TextFile.h"

#include "Object/FileBytes.h"

#include <fstream>

namespace idiophone {

Result<std::string> readTextFile(const std::filesystem::path& file, std::uintmax_t limitBytes) {
    return readBytes(file, limitBytes).map_error([&](const Error& fault) {
        return Error{shownNameOf(file) + ": " + fault.message};
    });
}

Result<void> writeTextFile(const std::filesystem::path& file, const std::string& text) {
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    stream << text;
    stream.close();
    if (!stream)
        return failure(shownNameOf(file) + ": the file cannot be written");
    return {};
}

} // namespace idiophone
