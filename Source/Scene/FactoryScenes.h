// The scenes that ship inside the program.
#pragma once

#include "Scene/Scene.h"

#include <span>
#include <string>
#include <string_view>

namespace idiophone {

/// In a fixed order. Parsed once; any thread but audio.
std::span<const Scene> factoryScenes();

/// The factory scene of that name (case-insensitive), or nullptr.
const Scene* findFactoryScene(std::string_view name);

/// "'Dice on a xylophone', 'A hundred rings' and 'Pebble in a wok'", for sentences.
std::string factoryScenesInWords();

} // namespace idiophone
