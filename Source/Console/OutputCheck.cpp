#include "Console/OutputCheck.h"

#include "Object/FileBeside.h"

namespace idiophone {

Result<void> checkWritable(const std::filesystem::path& file) {
    std::error_code ignored;
    const auto there = std::filesystem::status(file, ignored);
    if (std::filesystem::is_directory(there))
        return failure(file.string() + ": it is a directory");
    if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
        return {}; // a device or a pipe, which is written directly
    const auto trial = makeFileBeside(behindLinks(file));
    if (!trial)
        return failure(file.string() + ": the file cannot be written");
    std::filesystem::remove(*trial, ignored);
    return {};
}

Result<void> makeDirectory(const std::filesystem::path& directory) {
    std::error_code fault;
    std::filesystem::create_directories(directory, fault);
    if (!std::filesystem::is_directory(directory, fault))
        return failure(directory.string() + ": the directory cannot be created");
    return {};
}

} // namespace idiophone
