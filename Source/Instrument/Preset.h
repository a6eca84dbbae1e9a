// A preset: which objects the keys play, where they are struck, and a value for every parameter.
// Plain data and its JSON; building the instrument from it is Instrument.h's.
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
    bars,   ///< one object a key
    zones,  ///< one object; the strike moves along a path over it as the keys go up
    scaled, ///< one object, resized for each key to its pitch
    scene   ///< a scene of rigid bodies, which keys set in motion (Scene/SceneStage.h)
};

/// How MIDI notes find objects and strike points.
struct KeyMap {
    KeyMapKind kind = KeyMapKind::bars;
    int lowestNote = 0;    ///< 0 to 127
    int highestNote = 127; ///< lowestNote to 127
    /// `bars` and `scaled`: keys from here to there beside the map's own play the nearest of these,
    /// resized to their pitch. By default those of a piano.
    int resizedFrom = 21; ///< 0 to 127
    int resizedTo = 108;  ///< 0 to 127; below `resizedFrom` there are none
    /// The modal object: a factory object's name ("plate") or a file's path; for `bars`, `{note}`
    /// in it stands for the MIDI note, and notes between the lowest and the highest whose object
    /// does not exist play the nearest one, resized. For `scene` the factory scene's name or its
    /// file's path.
    std::string object;
    /// Where keys strike: a path over the object, from its lowest key's end to its highest's, in
    /// units of the object's bounding box (−1 to 1 along x, y and z). Each place is the
    /// nearest one on the surface. `zones` spread the keys along the path; the other maps
    /// strike at `strikeAt` of the way.
    std::vector<std::array<double, 3>> strikePath{{-1, 0, 0}, {1, 0, 0}};
    /// 0 to 1: one place for all keys, or places for evenly spread keys from the lowest to the
    /// highest, between which the others strike. Not empty.
    std::vector<double> strikeAt{0.5};
    /// How far beside the path "strike position across" reaches, in units of the bounding box.
    double strikeWidth = 1; ///< 0 to 1
    /// `scaled`: which MIDI note the object sounds at its own size, by its lowest mode; found from
    /// the object where it is negative.
    double referenceNote = -1;
    /// How much louder each key strikes than its mallet does, so that a keyboard is even: from the
    /// lowest note on, in dB, ±40; empty: none. `idiophone presets` finds it.
    std::vector<double> voicingDb = {};

    /// The object that a note plays: `object` with `{note}` replaced, where there is one for each.
    std::string objectFor(int midiNote) const;
    /// Where on the path a note strikes: 0 to 1.
    double strikePlace(int midiNote) const;

    bool operator==(const KeyMap&) const = default;
};

struct Preset {
    std::string name;
    std::string author;
    std::string description;
    std::vector<std::string> tags;
    KeyMap keyMap;
    ParameterValues parameters; ///< those the file does not name have their default
    /// Whose material and mallet "match loudness" keeps to, where it is not `parameters`.
    std::optional<ParameterValues> matchedTo;
    Surface surface;        ///< what scrapes and rolls sound like; valid
    std::uint32_t seed = 1; ///< of their noise, spread and chatter, so that a render repeats
    ModeSet mutedModes;     ///< of its objects, by modeSetKey
    /// Ids of parameters in the file that this version does not know.
    std::vector<std::string> unknownParameters;

    bool operator==(const Preset&) const = default;

    /// What "match loudness" keeps to.
    const ParameterValues& matched() const { return matchedTo ? *matchedTo : parameters; }
};

inline constexpr int presetFormatVersion = 1;
inline constexpr std::size_t largestPresetBytes = 1 << 20;
inline constexpr std::size_t mostTags = 1000;
/// Longer texts are cut, as the browser draws and searches them all: a state has to open whatever
/// its preset is called.
inline constexpr std::size_t longestNameBytes = 500; ///< of a name, an author and each tag
inline constexpr std::size_t longestDescriptionBytes = 4000;
inline constexpr std::size_t longestTagsBytes = 4000; ///< together; those beyond are left out
inline constexpr std::size_t mostPathPoints = 1000;   ///< of KeyMap::strikePath

/// Parses a preset file; `name` stands for it in errors: it is too large, no JSON, lacks something
/// or has something that it cannot be. Objects and scenes are named, not looked for. Not for the
/// audio thread.
Result<Preset> parsePreset(std::string_view text, std::string_view name);

/// The same of a preset in a saved state, which may be of any length and need not have a name.
Result<Preset> parseSavedPreset(std::string_view text, std::string_view name);

/// The preset as JSON text that `parseSavedPreset` reads back to an equal preset, and `parsePreset`
/// where it takes one of that length and name. Any thread but audio.
std::string encodePreset(const Preset& preset);

} // namespace idiophone
