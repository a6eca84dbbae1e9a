// Scenes from files.
#pragma once

#include "Object/Result.h"
#include "Scene/Scene.h"

#include <filesystem>
#include <string_view>

namespace idiophone {

/// The scene of a file of at most `largestSceneBytes`. Objects and presets that it names by a path
/// are seen from its folder. The error names the file and the place in it. Not for the audio
/// thread.
Result<Scene> readSceneFile(const std::filesystem::path& file);

/// The scene file that a project names by its whole path, in UTF-8. Where it is not there and lies
/// in somebody's settings folder ("/home/ann/.config/Idiophone/Scenes/coins.json"), the file of
/// that name in this user's, if there is one: users and machines have their folders elsewhere. Not
/// for the audio thread.
std::filesystem::path sceneFileNamed(std::string_view name);

} // namespace idiophone
