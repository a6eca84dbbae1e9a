#include "Console/OutputCheck.h"

#include "Object/FileBeside.h"

namespace idiophone {

Result<void> checkWritable(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        return failure(file.string() + ": it is a directory");
    const auto trial = makeFileBeside(file);
    if (!trial)
        return failure(file.string() + ": the file cannot be written");
    std::filesystem::remove(*trial, ignored);
    return {};
}

Result<void> makeDirectory(const std::filesystem::path& directory) {
    std::error_code fault;
    std::filesystem::create_directories(directory, fault);
    if (!std::filesystem::is_directory(directory, fault))
        return failure(directory.string() + ": the directory cannot be made");
    return {};
}

} // namespace idiophone
