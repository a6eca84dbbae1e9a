#include "Plugin/FileKinds.h"

#include "Editor/Utf8.h"

#include <algorithm>
#include <initializer_list>

namespace idiophone {
namespace {

using Extensions = std::initializer_list<const char*>;
constexpr Extensions meshes{".obj", ".off", ".ply", ".stl"}, modalObjects{".modal"}, scales{".scl"},
    keyboardMappings{".kbm"};

bool hasExtension(const std::filesystem::path& file, Extensions known) {
    const auto extension = textOf(file.extension());
    return std::ranges::any_of(known,
                               [&](const char* each) { return extension.equalsIgnoreCase(each); });
}

std::string patternsOf(Extensions some, Extensions others) {
    std::string patterns;
    for (const auto& extensions : {some, others})
        for (const char* extension : extensions)
            patterns += (patterns.empty() ? "*" : ";*") + std::string(extension);
    return patterns;
}

} // namespace

bool isModalFile(const std::filesystem::path& file) {
    return hasExtension(file, modalObjects);
}

bool isMeshFile(const std::filesystem::path& file) {
    return hasExtension(file, meshes);
}

bool isScale(const std::filesystem::path& file) {
    return hasExtension(file, scales);
}

bool isKeyboardMapping(const std::filesystem::path& file) {
    return hasExtension(file, keyboardMappings);
}

std::string objectFilePatterns() {
    return patternsOf(meshes, modalObjects);
}

std::string tuningFilePatterns() {
    return patternsOf(scales, keyboardMappings);
}

std::string fileNameOf(const std::filesystem::path& file) {
    return textOf(file.filename()).toStdString();
}

} // namespace idiophone
