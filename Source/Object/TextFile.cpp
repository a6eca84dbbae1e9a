#include "Object/TextFile.h"

#include <fstream>

namespace idiophone {

Result<std::string> readTextFile(const std::filesystem::path& file, std::uintmax_t limitBytes) {
    std::error_code fault;
    if (std::filesystem::is_directory(file, fault))
        return failure(file.string() + ": it is a directory");
    std::ifstream stream(file, std::ios::binary);
    const auto size = std::filesystem::file_size(file, fault);
    if (!stream || fault)
        return failure(file.string() + ": the file cannot be opened");
    if (size > limitBytes)
        return failure(file.string() + ": it is larger than " + std::to_string(limitBytes >> 20) +
                       " MB");
    std::string text(static_cast<std::size_t>(size), '\0');
    if (!stream.read(text.data(), static_cast<std::streamsize>(text.size())))
        return failure(file.string() + ": the file cannot be read");
    return text;
}

Result<void> writeTextFile(const std::filesystem::path& file, const std::string& text) {
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    stream << text;
    stream.close();
    if (!stream)
        return failure(file.string() + ": the file cannot be written");
    return {};
}

} // namespace idiophone
