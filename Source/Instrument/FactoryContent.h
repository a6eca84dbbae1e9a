// The presets and modal objects that ship inside the program.
#pragma once

#include "Instrument/Preset.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace idiophone {

/// Returns the factory presets; a new instance plays the first. Parsed once; any thread except
/// the audio thread.
std::span<const Preset> factoryPresets();

/// Returns the factory preset of that name (case-insensitive), or nullptr.
const Preset* findFactoryPreset(std::string_view name);

/// Returns "Init", the preset to start from: the factory's rosewood bars struck in the middle, as
/// loud as the factory presets. All parameters except the level have their defaults.
Preset initialPreset();

/// Returns the .modal bytes of a factory object such as "xylophone-72", valid for the life of the
/// program.
std::optional<std::span<const std::byte>> factoryObject(std::string_view name);

} // namespace idiophone
