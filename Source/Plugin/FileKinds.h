// Names the kinds of files that the plugin opens, by extension in upper or lower case.
#pragma once

#include <filesystem>
#include <string>

namespace idiophone {

bool isModalFile(const std::filesystem::path& file);       ///< .modal
bool isMeshFile(const std::filesystem::path& file);        ///< .obj, .off, .ply, .stl
bool isScale(const std::filesystem::path& file);           ///< .scl
bool isKeyboardMapping(const std::filesystem::path& file); ///< .kbm

std::string objectFilePatterns(); ///< "*.obj;*.off;*.ply;*.stl;*.modal"
std::string tuningFilePatterns(); ///< "*.scl;*.kbm"

/// Returns the name without its folder, in UTF-8.
std::string fileNameOf(const std::filesystem::path& file);

} // namespace idiophone
