#include "Scene/SceneFile.h"

#include "Instrument/FactoryContent.h"
#include "Object/TextFile.h"
#include "Scene/SceneText.h"

namespace idiophone {

Result<Scene> readSceneFile(const std::filesystem::path& file) {
    auto scene = readTextFile(file, largestSceneBytes).and_then([&](const std::string& text) {
        return parseScene(text, file.filename().string());
    });
    if (!scene)
        return scene;
    for (auto& kind : scene->kinds)
        if (!kind.ball && !factoryObject(kind.object))
            kind.object = (file.parent_path() / kind.object).string();
    if (scene->keyboard && findFactoryPreset(scene->keyboard->preset) == nullptr)
        scene->keyboard->preset = (file.parent_path() / scene->keyboard->preset).string();
    return scene;
}

} // namespace idiophone
