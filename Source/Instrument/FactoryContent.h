// What ships inside the program: presets and their modal objects.
#pragma once

#include "Instrument/Preset.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace idiophone {

/// The factory presets, the first of which a new instance plays. Parsed once; any thread but audio.
std::span<const Preset> factoryPresets();

/// The factory preset of that name (case-insensitive), or nullptr.
const Preset* findFactoryPreset(std::string_view name);

/// The .modal bytes of a factory object such as "xylophone-72", for the life of the program.
std::optional<std::span<const std::byte>> factoryObject(std::string_view name);

} // namespace idiophone
