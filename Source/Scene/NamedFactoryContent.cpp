// The scenes and presets of a page, which has no files.
#include "Scene/NamedContent.h"

#include "Instrument/FactoryContent.h"
#include "Object/OneLine.h"
#include "Scene/FactoryScenes.h"

namespace idiophone {

Result<Scene> sceneNamed(const std::string& name) {
    if (const auto* factory = findFactoryScene(name))
        return *factory;
    return failure("the scene " + inQuotes(name) + " is not one of the factory's");
}

Result<Preset> presetNamed(const std::string& name) {
    if (const auto* factory = findFactoryPreset(name))
        return *factory;
    return failure("the keyboard's preset " + inQuotes(name) + " is not one of the factory's");
}

} // namespace idiophone
