#include "Scene/FactoryScenes.h"

#include "Object/EmbeddedFiles.h"
#include "Scene/SceneText.h"

namespace idiophone {

std::span<const EmbeddedFile> sceneFiles(); // generated

std::span<const Scene> factoryScenes() {
    static const auto scenes = parseEmbedded<Scene>(sceneFiles(), parseScene);
    return scenes;
}

const Scene* findFactoryScene(std::string_view name) {
    return findNamed(factoryScenes(), name);
}

std::string factoryScenesInWords() {
    std::string words;
    const auto scenes = factoryScenes();
    for (std::size_t k = 0; k < scenes.size(); ++k)
        words += (k == 0 ? "'" : k + 1 == scenes.size() ? " and '" : ", '") + scenes[k].name + "'";
    return words;
}

} // namespace idiophone
