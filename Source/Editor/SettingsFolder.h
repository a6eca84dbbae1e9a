// Finds the folder of this user's Idiophone settings.
#pragma once

#include "Editor/Utf8.h"
#include "Object/MaterialFile.h"

namespace idiophone {

/// The folder of the user's materials, presets and window settings; an empty File if the
/// environment names none.
inline juce::File userSettingsFolder() {
    const auto materials = userMaterialFolder();
    return materials.empty() ? juce::File() : fileOf(materials.parent_path());
}

} // namespace idiophone
