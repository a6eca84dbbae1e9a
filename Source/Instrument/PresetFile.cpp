#include "Instrument/PresetFile.h"

#include "Instrument/FactoryContent.h"
#include "Object/FileBytes.h"
#include "Object/TextFile.h"

#include <algorithm>
#include <vector>

namespace idiophone {
namespace {

constexpr int foldersAbove = 4;

/// Returns the preset's folder, then those above it.
std::vector<std::filesystem::path> foldersFor(const std::filesystem::path& presetFile) {
    std::error_code fault;
    std::vector<std::filesystem::path> folders;
    auto folder = std::filesystem::absolute(presetFile, fault).parent_path();
    for (int above = 0; above <= foldersAbove && !folder.empty(); ++above) {
        folders.push_back(folder);
        folder = folder.parent_path();
    }
    return folders;
}

/// Returns the first of the folders that has a file of that relative path.
std::optional<std::filesystem::path> folderWith(const std::filesystem::path& name,
                                                const std::filesystem::path& presetFile) {
    std::error_code fault;
    for (const auto& folder : foldersFor(presetFile))
        if (std::filesystem::is_regular_file(folder / name, fault))
            return folder;
    return std::nullopt;
}

/// Returns the part of the file's path, as written, after the folder; empty if there is none.
std::filesystem::path behind(const std::filesystem::path& folder,
                             const std::filesystem::path& file) {
    const auto [inFolder, inFile] =
        std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    std::filesystem::path rest;
    if (inFolder == folder.end())
        for (auto part = inFile; part != file.end(); ++part)
            rest /= *part;
    return rest.lexically_normal();
}

} // namespace

Result<Preset> readPresetFile(const std::filesystem::path& file) {
    return readTextFile(file, largestPresetBytes).and_then([&](const std::string& text) {
        return parsePreset(text, nameOf(file.filename()));
    });
}

KeyMap withObjectsBeside(KeyMap keyMap, const std::filesystem::path& presetFile) {
    if (keyMap.kind == KeyMapKind::kit) {
        std::vector parts(keyMap.parts.begin(), keyMap.parts.end());
        for (auto& part : parts)
            part.keyMap = withObjectsBeside(std::move(part.keyMap), presetFile);
        return kitOf(std::move(parts));
    }
    if (factoryObject(keyMap.objectFor(keyMap.lowestNote)))
        return keyMap;
    keyMap.object = localName(keyMap.object);
    const auto first = keyMap.objectFor(keyMap.lowestNote);
    if (const auto folder = folderWith(pathNamed(first), presetFile))
        keyMap.object = storedNameOf(*folder / pathNamed(keyMap.object));
    return keyMap;
}

std::optional<std::string> nameBeside(const std::filesystem::path& file,
                                      const std::filesystem::path& presetFile) {
    const auto folders = foldersFor(presetFile);
    // If a folder is a symbolic link, `..` after it leads to the parent of its target.
    const auto isSame = [&](const std::filesystem::path& plain) {
        std::error_code fault;
        return std::filesystem::equivalent(plain, file, fault);
    };
    // Keep a path with `..` as the preset wrote it: it stays valid if the folder is renamed.
    if (!folders.empty())
        if (const auto written = behind(folders.front(), file);
            !written.empty() && *written.begin() == ".." &&
            folderWith(written, presetFile) == folders.front() && isSame(folders.front() / written))
            return storedNameOf(written);
    const auto normal = file.lexically_normal();
    const auto& plain = isSame(normal) ? normal : file;
    for (const auto& folder : folders) {
        if (folder == folder.root_path())
            break; // the whole disk lies below this folder
        const auto name = plain.lexically_relative(folder);
        // Skip the name if a file of that name nearer to the preset would be found first.
        if (!name.empty() && *name.begin() != ".." && folderWith(name, presetFile) == folder)
            return storedNameOf(name);
    }
    return std::nullopt;
}

} // namespace idiophone
