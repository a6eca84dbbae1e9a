#include "Scene/NamedContent.h"

#include "Instrument/FactoryContent.h"
#include "Instrument/PresetFile.h"
#include "Object/FileBytes.h"
#include "Object/OneLine.h"
#include "Scene/FactoryScenes.h"
#include "Scene/SceneFile.h"

namespace idiophone {

Result<Scene> sceneNamed(const std::string& nameOrFile) {
    if (const auto* factory = findFactoryScene(nameOrFile))
        return *factory;
    return readSceneFile(sceneFileNamed(nameOrFile));
}

Result<Preset> presetNamed(const std::string& nameOrFile) {
    if (const auto* factory = findFactoryPreset(nameOrFile))
        return *factory;
    const auto file = pathNamed(nameOrFile);
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        return failure("the keyboard's preset " + oneLine(nameOrFile, nameOrFile.size()) +
                       " is neither of the factory's nor a file");
    return readPresetFile(file).map([&](Preset preset) {
        preset.keyMap = withObjectsBeside(preset.keyMap, file);
        return preset;
    });
}

} // namespace idiophone
