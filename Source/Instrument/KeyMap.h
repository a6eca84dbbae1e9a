// The object that each key plays, and where it is struck.
#pragma once

#include "Object/Result.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

enum class KeyMapKind {
    bars,   ///< one object per key
    zones,  ///< one object; the strike moves along a path over it as the keys go up
    scaled, ///< one object, resized for each key to its pitch
    scene,  ///< a scene of rigid bodies, which keys set in motion (Scene/SceneStage.h)
    kit     ///< parts, each with a key map of its own
};

struct KitPart;

/// The parts of a kit, which never change; copies share them.
class KitParts {
public:
    KitParts() = default;
    explicit KitParts(std::vector<KitPart> parts);

    const KitPart* begin() const;
    const KitPart* end() const;
    std::size_t size() const;
    bool empty() const { return size() == 0; }
    bool operator==(const KitParts& other) const;

private:
    std::shared_ptr<const std::vector<KitPart>> list;
};

/// How MIDI notes find objects and strike points. A kit has only its parts; its notes span theirs.
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
    /// `kit`: 1 to `maximumKitParts`; of at most `kitLayers` at any key and velocity. Otherwise
    /// empty.
    KitParts parts = {};

    /// Returns the object that a note plays: `object` with `{note}` replaced for `bars`. A kit has
    /// none.
    std::string objectFor(int midiNote) const;
    /// Returns the place on the path at which a note strikes, 0 to 1.
    double strikePlace(int midiNote) const;

    bool operator==(const KeyMap&) const = default;
};

/// Keys of a kit with a range of velocities. Resized keys outside a part's own play only where no
/// part has a key.
struct KitPart {
    KeyMap keyMap; ///< `bars`, `zones` or `scaled`
    int lowestVelocity = 1;
    int highestVelocity = 127; ///< lowestVelocity to 127
    /// Choices of ParameterId::material (not the custom one) and ParameterId::mallet that replace
    /// the parameters'. Without one the part follows the parameter.
    std::optional<int> material = {}, mallet = {};
    double levelDb = 0; ///< gain of its impulses, ±40
    /// 1 to `maximumChokeGroup`: a strike on one key of the group damps the group's other keys. 0:
    /// none.
    int chokeGroup = 0;
    /// 1 to `maximumOutputs`: where it sounds if ParameterId::outputs chooses by parts. 0: the
    /// parts go round the outputs.
    int output = 0;

    bool operator==(const KitPart&) const = default;
};

inline constexpr std::size_t maximumPathPoints = 1000; ///< of KeyMap::strikePath
inline constexpr std::size_t maximumKitParts = 128;
inline constexpr int kitLayers = 2;
inline constexpr int maximumChokeGroup = 16;

/// Returns the key map of a kit, whose notes span its parts.
KeyMap kitOf(std::vector<KitPart> parts);

/// Fails if the parts are none or too many, lie beyond the kit's notes, are scenes or kits, or are
/// more than `kitLayers` at once. The error is the predicate of a sentence about the parts: "are
/// more than 2 on key 60 at velocity 1".
Result<void> validKit(const KeyMap& kit);

/// Returns the distinct objects that the notes of a map name, or of all parts of a kit.
std::vector<std::string> objectNames(const KeyMap& map);

} // namespace idiophone
