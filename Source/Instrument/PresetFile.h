// Presets as files on disk, and the modal objects beside them.
#pragma once

#include "Instrument/Preset.h"

#include <filesystem>
#include <optional>
#include <string>

namespace idiophone {

/// Reads a preset; the error names the file. Not for the audio thread.
Result<Preset> readPresetFile(const std::filesystem::path& file);

/// Returns the key map with the full path of its object, if a file of that relative path lies in
/// the preset's folder or one of the four above it. Otherwise the name stays as it is (localName),
/// as for factory objects.
KeyMap withObjectsBeside(KeyMap keyMap, const std::filesystem::path& presetFile);

/// Returns the relative path by which a preset at that place finds a file (withObjectsBeside),
/// normalised and with forward slashes. Returns nothing if the file does not exist or the preset
/// cannot find it. The path contains ".." only if the file's own path leads up from the preset's
/// folder by "..".
std::optional<std::string> nameBeside(const std::filesystem::path& file,
                                      const std::filesystem::path& presetFile);

} // namespace idiophone
