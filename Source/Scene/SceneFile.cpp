#include "Scene/SceneFile.h"

#include "Gltf/GltfFile.h"
#include "Instrument/FactoryContent.h"
#include "Object/FileBytes.h"
#include "Object/MaterialFile.h"
#include "Object/TextFile.h"
#include "Scene/GltfScene.h"
#include "Scene/SceneText.h"

namespace idiophone {

Result<Scene> readSceneFile(const std::filesystem::path& file) {
    if (isGltfFile(file))
        return readGltfScene(file);
    auto scene = readTextFile(file, largestSceneBytes).and_then([&](const std::string& text) {
        return parseScene(text, nameOf(file.filename()));
    });
    if (!scene)
        return scene;
    const auto beside = [&](const std::string& name) {
        return storedNameOf(file.parent_path() / pathNamed(localName(name)));
    };
    for (auto& kind : scene->kinds)
        if (kind.given == nullptr && !factoryObject(kind.object))
            kind.object = beside(kind.object);
    if (scene->keyboard && findFactoryPreset(scene->keyboard->preset) == nullptr)
        scene->keyboard->preset = beside(scene->keyboard->preset);
    return scene;
}

std::filesystem::path sceneFileNamed(std::string_view name) {
    constexpr std::string_view settingsFolder = "/Idiophone/";
    const auto named = pathNamed(name);
    const auto own = userMaterialFolder().parent_path();
    std::error_code fault;
    if (std::filesystem::exists(named, fault) || own.empty())
        return named;
    for (auto at = name.find(settingsFolder); at != std::string_view::npos;
         at = name.find(settingsFolder, at + 1)) {
        auto file = own / pathNamed(localName(name.substr(at + settingsFolder.size())));
        if (std::filesystem::is_regular_file(file, fault))
            return file;
    }
    return named;
}

} // namespace idiophone
