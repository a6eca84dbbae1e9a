// Parses scenes from JSON text, as docs/scenes.md specifies.
#pragma once

#include "Object/Result.h"
#include "Scene/Scene.h"

#include <cstddef>
#include <string_view>

namespace idiophone {

inline constexpr int sceneFormatVersion = 1;
inline constexpr std::size_t largestSceneBytes = 1 << 22;

/// Parses a scene. `file` names it in errors, which also give the place in the file. Does not look
/// for the objects and presets that the scene names. Not for the audio thread.
Result<Scene> parseScene(std::string_view text, std::string_view file);

} // namespace idiophone
