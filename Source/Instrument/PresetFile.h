// Presets as files on disk, and the modal objects that lie beside them.
#pragma once

#include "Instrument/Preset.h"

#include <filesystem>
#include <optional>
#include <string>

namespace idiophone {

/// The error names the file. Not for the audio thread.
Result<Preset> readPresetFile(const std::filesystem::path& file);

/// The key map with the full path of its object where a file of that relative path lies in the
/// preset's folder or one of the four above it; else as it is (localName), as with factory objects.
KeyMap withObjectsBeside(KeyMap keyMap, const std::filesystem::path& presetFile);

/// The relative path by which a preset in that place would find a file, of forward slashes and
/// normal; nothing where there is no such file or it lies elsewhere. It leads up ("..") only where
/// the file's path does so from the preset's folder (withObjectsBeside).
std::optional<std::string> nameBeside(const std::filesystem::path& file,
                                      const std::filesystem::path& presetFile);

} // namespace idiophone
