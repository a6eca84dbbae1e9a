// A preset: the objects that the keys play, where they are struck, and a value for every parameter.
// Plain data and its JSON; Instrument.h builds the instrument from it.
#pragma once

#include "Instrument/ModeSet.h"
#include "Object/Result.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Surface.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace idiophone {

enum class KeyMapKind {
    bars,   ///< one object per key
    zones,  ///< one object; the strike moves along a path over it as the keys go up
    scaled, ///< one object, resized for each key to its pitch
    scene   ///< a scene of rigid bodies, which keys set in motion (Scene/SceneStage.h)
};

/// How MIDI notes find objects and strike points.
struct KeyMap {
    KeyMapKind kind = KeyMapKind::bars;
    int lowestNote = 0;    ///< 0 to 127
    int highestNote = 127; ///< lowestNote to 127
    /// `bars` and `scaled`: keys in this range, but outside the map's own, play the nearest of its
    /// keys, resized to their pitch. The default is a piano's range.
    int resizedFrom = 21; ///< 0 to 127
    int resizedTo = 108;  ///< 0 to 127; below `resizedFrom`: no such keys
    /// The modal object: a factory object's name ("plate") or a file's path. For `bars`, `{note}`
    /// in it stands for the MIDI note; notes without an object play the nearest one, resized. For
    /// `scene`, the factory scene's name or its file's path.
    std::string object;
    /// Path over the object along which keys strike, from the lowest key's end to the highest's.
    /// Its unit is the object's bounding box (−1 to 1 along x, y and z). Each place is the nearest
    /// one on the surface. `zones` spread the keys along the path; the other maps strike at
    /// `strikeAt`.
    std::vector<std::array<double, 3>> strikePath{{-1, 0, 0}, {1, 0, 0}};
    /// Places on the path, 0 to 1; not empty. One place serves all keys. Several places belong to
    /// evenly spread keys from the lowest to the highest; other keys interpolate between them.
    std::vector<double> strikeAt{0.5};
    /// Reach of "strike position across" beside the path, in units of the bounding box.
    double strikeWidth = 1; ///< 0 to 1
    /// `scaled`: MIDI note of the lowest mode at the object's own size. If negative, it is computed
    /// from the object.
    double referenceNote = -1;
    /// Gains that make a keyboard even, for keys from the lowest note on, in dB, ±40; empty: none.
    /// `idiophone presets` computes them.
    std::vector<double> voicingDb = {};

    /// Returns the object that a note plays: `object` with `{note}` replaced for `bars`.
    std::string objectFor(int midiNote) const;
    /// Returns the place on the path at which a note strikes, 0 to 1.
    double strikePlace(int midiNote) const;

    bool operator==(const KeyMap&) const = default;
};

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
inline constexpr std::size_t longestTagsBytes = 4000;  ///< together; later tags are dropped
inline constexpr std::size_t maximumPathPoints = 1000; ///< of KeyMap::strikePath

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
