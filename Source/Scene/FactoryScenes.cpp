#include "Scene/FactoryScenes.h"

#include "Object/SameName.h"
#include "Scene/SceneText.h"
#include "SceneFiles.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace idiophone {
namespace {

std::vector<Scene> parseAll() {
    std::vector<std::pair<std::string_view, std::string_view>> files;
    for (int i = 0; i < SceneFiles::namedResourceListSize; ++i) {
        int size = 0;
        const char* bytes = SceneFiles::getNamedResource(SceneFiles::namedResourceList[i], size);
        files.emplace_back(SceneFiles::originalFilenames[i],
                           std::string_view(bytes, static_cast<std::size_t>(size)));
    }
    std::ranges::sort(files); // the files' names begin with their place in the list
    std::vector<Scene> scenes;
    for (const auto& [name, text] : files) {
        auto scene = parseScene(text, name);
        // Part of the program, and every one of them is parsed by the tests.
        if (!scene)
            std::abort();
        scenes.push_back(std::move(*scene));
    }
    return scenes;
}

} // namespace

std::span<const Scene> factoryScenes() {
    static const auto scenes = parseAll();
    return scenes;
}

const Scene* findFactoryScene(std::string_view name) {
    const auto scenes = factoryScenes();
    const auto found = std::ranges::find_if(
        scenes, [&](const Scene& scene) { return sameName(scene.name, name); });
    return found == scenes.end() ? nullptr : &*found;
}

std::string factoryScenesInWords() {
    std::string words;
    const auto scenes = factoryScenes();
    for (std::size_t k = 0; k < scenes.size(); ++k)
        words += (k == 0 ? "'" : k + 1 == scenes.size() ? " and '" : ", '") + scenes[k].name + "'";
    return words;
}

} // namespace idiophone
