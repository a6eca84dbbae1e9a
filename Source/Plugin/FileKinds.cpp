#include "Plugin/FileKinds.h"

#include <algorithm>
#include <initializer_list>
#include <juce_core/juce_core.h>

namespace idiophone {
namespace {

bool hasExtension(const std::filesystem::path& file, std::initializer_list<const char*> known) {
    const juce::String extension = juce::String::fromUTF8(file.extension().string().c_str());
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

std::string nameOf(const std::filesystem::path& file) {
    return file.filename().string();
}

} // namespace idiophone
