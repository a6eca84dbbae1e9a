// A preset: the objects that the keys play, where they are struck, and a value for every parameter.
// Plain data and its JSON; Instrument.h builds the instrument from it.
#pragma once

#include "Instrument/KeyMap.h"
#include "Instrument/ModeSet.h"
#include "Object/Result.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Surface.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace idiophone {

struct Preset {
    std::string name;
    std::string author;
    std::string description;
    std::vector<std::string> tags;
    KeyMap keyMap;
    ParameterValues parameters; ///< parameters missing from the file have their default
    /// Values whose material and mallet "match loudness" keeps to, if not `parameters`.
    std::optional<ParameterValues> matchedTo;
    Surface surface;        ///< sound of scrapes and rolls; valid
    std::uint32_t seed = 1; ///< seeds noise, spread and chatter, so that a render repeats
    ModeSet mutedModes;     ///< of its objects, by modeSetKey
    /// Ids in the file that this version does not know.
    std::vector<std::string> unknownParameters;

    bool operator==(const Preset&) const = default;

    /// Returns the values that "match loudness" keeps to.
    const ParameterValues& matched() const { return matchedTo ? *matchedTo : parameters; }
};

inline constexpr int presetFormatVersion = 1;
inline constexpr std::size_t largestPresetBytes = 1 << 20;
inline constexpr std::size_t maximumTags = 1000;
/// Longer texts are cut, because the browser draws and searches them all. A state must open with
/// any name of its preset.
inline constexpr std::size_t longestNameBytes = 500; ///< limit of a name, an author and each tag
inline constexpr std::size_t longestDescriptionBytes = 4000;
inline constexpr std::size_t longestTagsBytes = 4000; ///< together; later tags are dropped

/// Parses a preset file; `name` stands for it in errors. Fails if the file is too large or not
/// JSON, or if a value is missing or wrong. Does not look for the objects and scenes. Not for the
/// audio thread.
Result<Preset> parsePreset(std::string_view text, std::string_view name);

/// Parses a preset in a saved state, which may have any length and no name.
Result<Preset> parseSavedPreset(std::string_view text, std::string_view name);

/// Returns the preset as JSON text. `parseSavedPreset` reads it back to an equal preset; so does
/// `parsePreset`, within its limits of length and name. Any thread except the audio thread.
std::string encodePreset(const Preset& preset);

} // namespace idiophone
