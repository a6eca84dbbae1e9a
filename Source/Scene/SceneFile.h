// Scenes from files.
#pragma once

#include "Object/Result.h"
#include "Scene/Scene.h"

#include <filesystem>

namespace idiophone {

/// The scene of a file of at most `largestSceneBytes`. Objects and presets that it names by a path
/// are seen from its folder. The error names the file and the place in it. Not for the audio
/// thread.
Result<Scene> readSceneFile(const std::filesystem::path& file);

} // namespace idiophone
