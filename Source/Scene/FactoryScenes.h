// The scenes that ship inside the program.
#pragma once

#include "Scene/Scene.h"

#include <span>
#include <string>
#include <string_view>

namespace idiophone {

/// Returns the scenes in a fixed order. Parses them once. Any thread except the audio thread.
std::span<const Scene> factoryScenes();

/// Returns the factory scene of that name (case-insensitive), or nullptr.
const Scene* findFactoryScene(std::string_view name);

/// Returns the names as a list for a sentence: "'Dice on a xylophone', 'A hundred rings' and
/// 'Pebble in a wok'".
std::string factoryScenesInWords();

} // namespace idiophone
