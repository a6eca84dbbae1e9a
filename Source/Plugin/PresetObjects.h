// Stores the non-factory objects of a preset file beside it, as .modal files named by content.
// Presets share them, and nothing is overwritten.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/Preset.h"

#include <juce_core/juce_core.h>
#include <memory>

namespace idiophone {

inline constexpr const char* presetObjectFolder = "Objects";

/// Writes the instrument's objects below `folder`, except factory objects and files already there.
/// Returns the key map with names relative to `folder` ("Objects/Bowl-1f3a.modal"). The instrument
/// was built from the key map. This and `withSceneBeside` are not for the audio thread.
Result<KeyMap>
writePresetObjects(const KeyMap& keyMap, const Instrument& instrument, const juce::File& folder);

/// Returns the key map to write into that preset file. A scene that lies where presets look for
/// objects gets a relative path instead of this machine's absolute one.
KeyMap withSceneBeside(KeyMap keyMap, const juce::File& presetFile);

struct PresetInstrument {
    KeyMap keyMap; ///< the instrument was built from it
    std::shared_ptr<const Instrument> instrument;
    std::string notice; ///< a sentence if a stand-in plays for a missing object; otherwise empty
};

/// Builds the instrument of a preset read from a file. Objects keep the names of the key map,
/// wherever their files are (withObjectsBeside); a scene gets its file's absolute path. If an
/// object is missing, a factory object plays its keys. A file that exists and cannot be read is an
/// error.
Result<PresetInstrument> buildPresetInstrument(const KeyMap& keyMap, const juce::File& presetFile);

} // namespace idiophone
