#include "Console/OutputCheck.h"

#include <fstream>

namespace idiophone {

Result<void> checkWritable(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        return failure(file.string() + ": it is a directory");
    // The name that writeModalObject writes to before it renames.
    auto trial = file;
    trial += ".part";
    const bool created = std::ofstream(trial, std::ios::binary).is_open();
    std::filesystem::remove(trial, ignored);
    if (!created)
        return failure(file.string() + ": the file cannot be written");
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
