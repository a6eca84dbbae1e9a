// Scenes from files.
#pragma once

#include "Object/Result.h"
#include "Scene/Scene.h"

#include <filesystem>

namespace idiophone {

/// The scene of a file. Objects and presets that it names by a path are seen from its folder.
Result<Scene> readSceneFile(const std::filesystem::path& file);

} // namespace idiophone
