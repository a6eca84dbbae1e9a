// The kinds of files that the plugin opens, by extension in any case.
#pragma once

#include <filesystem>
#include <string>

namespace idiophone {

// Patterns as file choosers take them.
/// Meshes, modal objects and recordings.
inline constexpr const char* objectFiles =
    "*.obj;*.off;*.ply;*.stl;*.gltf;*.glb;*.modal;*.wav;*.flac;*.aif;*.aiff";
inline constexpr const char* meshFiles = "*.obj;*.off;*.ply;*.stl;*.gltf;*.glb";
inline constexpr const char* modalFiles = "*.modal";
inline constexpr const char* recordingFiles = "*.wav;*.flac;*.aif;*.aiff";
inline constexpr const char* tuningFiles = "*.scl;*.kbm"; ///< scales and keyboard mappings
inline constexpr const char* scaleFiles = "*.scl";

/// Returns whether one of these patterns has the file's extension.
bool matches(const std::filesystem::path& file, const char* patterns);

/// Returns the name without its folder, in UTF-8.
std::string fileNameOf(const std::filesystem::path& file);

/// Shortens a reader's sentence for the window: names the file without its folder.
std::string withoutFolder(const std::string& sentence, const std::filesystem::path& file);

} // namespace idiophone
