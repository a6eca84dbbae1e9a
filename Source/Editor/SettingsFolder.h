// Where this user's settings for Idiophone lie.
#pragma once

#include "Editor/Utf8.h"
#include "Object/MaterialFile.h"

namespace idiophone {

/// The folder of the user's materials, presets and windows; an empty file where the environment
/// names none.
inline juce::File userSettingsFolder() {
    const auto materials = userMaterialFolder();
    return materials.empty() ? juce::File() : fileOf(materials.parent_path());
}

} // namespace idiophone
