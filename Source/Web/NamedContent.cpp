// The scenes and presets in the WebAssembly module, which has no files.
#include "Scene/NamedContent.h"

#include "Object/EmbeddedFiles.h"
#include "Object/OneLine.h"
#include "Scene/FactoryScenes.h"

#include <span>

namespace idiophone {

std::span<const EmbeddedFile> keyboardPresetFiles(); // generated

Result<Scene> sceneNamed(const std::string& name) {
    if (const auto* factory = findFactoryScene(name))
        return *factory;
    return failure("the scene " + inQuotes(name) + " is not one of the factory's");
}

Result<Preset> presetNamed(const std::string& name) {
    static const auto presets = parseEmbedded<Preset>(keyboardPresetFiles(), parsePreset);
    if (const auto* preset = findNamed(std::span<const Preset>(presets), name))
        return *preset;
    return failure("the keyboard's preset " + inQuotes(name) +
                   " is none of those that the factory's scenes use");
}

} // namespace idiophone
