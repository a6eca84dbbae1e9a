// Scenes as JSON text; docs/scenes.md specifies it.
#pragma once

#include "Object/Result.h"
#include "Scene/Scene.h"

#include <cstddef>
#include <string_view>

namespace idiophone {

inline constexpr int sceneFormatVersion = 1;
inline constexpr std::size_t largestSceneBytes = 1 << 22;

/// Parses a scene; `file` stands for it in errors, which name the place in the file. Objects and
/// presets are named, not looked for. Not for the audio thread.
Result<Scene> parseScene(std::string_view text, std::string_view file);

} // namespace idiophone
