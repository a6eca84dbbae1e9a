// Finds the scene that a key map names, and the preset that a scene names.
#pragma once

#include "Instrument/Preset.h"
#include "Scene/Scene.h"

#include <string>

namespace idiophone {

/// Returns the factory scene of that name, or reads the scene file. In WebAssembly there are
/// factory scenes only. The error names the scene. Not for the audio thread.
Result<Scene> sceneNamed(const std::string& nameOrFile);

/// Returns the factory preset of that name, or reads the preset file. In WebAssembly there are
/// factory presets only. The error names the preset. Not for the audio thread.
Result<Preset> presetNamed(const std::string& nameOrFile);

} // namespace idiophone
