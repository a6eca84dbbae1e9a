#include "Instrument/PresetFile.h"

#include "Instrument/FactoryContent.h"
#include "Object/FileBytes.h"
#include "Object/TextFile.h"

namespace idiophone {
namespace {

constexpr int foldersAbove = 4;

} // namespace

Result<Preset> readPresetFile(const std::filesystem::path& file) {
    return readTextFile(file, largestPresetBytes).and_then([&](const std::string& text) {
        return parsePreset(text, nameOf(file.filename()));
    });
}

KeyMap withObjectsBeside(KeyMap keyMap, const std::filesystem::path& presetFile) {
    const auto first = keyMap.objectFor(keyMap.lowestNote);
    if (factoryObject(first))
        return keyMap;
    std::error_code fault;
    auto folder = std::filesystem::absolute(presetFile, fault).parent_path();
    for (int above = 0; above <= foldersAbove && !folder.empty(); ++above) {
        if (std::filesystem::is_regular_file(folder / pathNamed(first), fault)) {
            keyMap.object = storedNameOf(folder / pathNamed(keyMap.object));
            break;
        }
        folder = folder.parent_path();
    }
    return keyMap;
}

} // namespace idiophone
