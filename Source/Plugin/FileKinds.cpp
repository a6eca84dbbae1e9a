#include "Plugin/FileKinds.h"

#include "Editor/Utf8.h"

#include <algorithm>
#include <initializer_list>

namespace idiophone {
namespace {

bool hasExtension(const std::filesystem::path& file, std::initializer_list<const char*> known) {
    const auto extension = textOf(file.extension());
    return std::ranges::any_of(known,
                               [&](const char* each) { return extension.equalsIgnoreCase(each); });
}

} // namespace

bool isModalFile(const std::filesystem::path& file) {
    return hasExtension(file, {".modal"});
}

bool isMeshFile(const std::filesystem::path& file) {
    return hasExtension(file, {".obj", ".off", ".ply", ".stl"});
}

bool isScale(const std::filesystem::path& file) {
    return hasExtension(file, {".scl"});
}

bool isKeyboardMapping(const std::filesystem::path& file) {
    return hasExtension(file, {".kbm"});
}

std::string fileNameOf(const std::filesystem::path& file) {
    return textOf(file.filename()).toStdString();
}

} // namespace idiophone
