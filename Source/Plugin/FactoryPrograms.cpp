#include "Plugin/FactoryPrograms.h"

#include "Instrument/FactoryContent.h"

#include <algorithm>

namespace idiophone {

std::string factoryPresetId(const std::string& name) {
    return "factory:" + name;
}

int factoryProgram(const std::string& presetId) {
    const auto presets = factoryPresets();
    const auto found = std::ranges::find_if(
        presets, [&](const Preset& preset) { return factoryPresetId(preset.name) == presetId; });
    return found == presets.end() ? -1 : static_cast<int>(std::distance(presets.begin(), found));
}

} // namespace idiophone
