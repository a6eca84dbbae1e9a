// The modal objects of a preset file that are not the factory's: they lie beside it as .modal files
// named after what they hold, so that presets share them and nothing is overwritten.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/Preset.h"

#include <juce_core/juce_core.h>
#include <memory>

namespace idiophone {

inline constexpr const char* presetObjectFolder = "Objects";

/// Writes the instrument's objects below `folder` unless they are there already or the factory has
/// them, and returns the key map with their names relative to it ("Objects/Bowl-1f3a.modal"). The
/// instrument was built from the key map. Not for the audio thread, as the next one.
Result<KeyMap>
writePresetObjects(const KeyMap& keyMap, const Instrument& instrument, const juce::File& folder);

/// The key map as the preset of that file is to have it: a scene by a path that leads there from
/// where presets look for their objects, if it lies there, and not by this machine's whole path.
KeyMap withSceneBeside(KeyMap keyMap, const juce::File& presetFile);

struct PresetInstrument {
    KeyMap keyMap; ///< from which the instrument was built
    std::shared_ptr<const Instrument> instrument;
    std::string notice; ///< a sentence where something plays in the place of what is missing
};

/// Builds the instrument of a preset that was read from a file; its objects keep the names of the
/// key map, wherever they lie (withObjectsBeside), but a scene gets its file's whole path. Where
/// they are missing, a factory object plays their keys; files that are there and cannot be read are
/// an error.
Result<PresetInstrument> buildPresetInstrument(const KeyMap& keyMap, const juce::File& presetFile);

} // namespace idiophone
