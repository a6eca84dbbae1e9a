#include "Scene/SceneFile.h"

#include "Instrument/FactoryContent.h"
#include "Object/FileBytes.h"
#include "Object/TextFile.h"
#include "Scene/SceneText.h"

namespace idiophone {

Result<Scene> readSceneFile(const std::filesystem::path& file) {
    auto scene = readTextFile(file, largestSceneBytes).and_then([&](const std::string& text) {
        return parseScene(text, nameOf(file.filename()));
    });
    if (!scene)
        return scene;
    const auto beside = [&](const std::string& name) {
        return storedNameOf(file.parent_path() / pathNamed(name));
    };
    for (auto& kind : scene->kinds)
        if (!kind.ball && !factoryObject(kind.object))
            kind.object = beside(kind.object);
    if (scene->keyboard && findFactoryPreset(scene->keyboard->preset) == nullptr)
        scene->keyboard->preset = beside(scene->keyboard->preset);
    return scene;
}

} // namespace idiophone
