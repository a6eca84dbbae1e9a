// Reads scene files.
#pragma once

#include "Object/Result.h"
#include "Scene/Scene.h"

#include <filesystem>
#include <string_view>

namespace idiophone {

/// Reads a scene from a JSON file of at most `largestSceneBytes`, or from a glTF file with rigid
/// bodies. Relative paths start at the file's folder. The error names the file and the place in it.
/// Not for the audio thread.
Result<Scene> readSceneFile(const std::filesystem::path& file);

/// Returns the scene file that a project names by its absolute path, in UTF-8. If it is missing,
/// its path may lie in the settings folder of another user or machine
/// ("/home/ann/.config/Idiophone/Scenes/coins.json"). Then returns the same file in this user's
/// settings folder if it exists. Not for the audio thread.
std::filesystem::path sceneFileNamed(std::string_view name);

} // namespace idiophone
