// An instrument ready to be played: its objects in memory and, for every MIDI note, the object and
// the place to strike. It is immutable, so any number of players share it.
#pragma once

#include "Instrument/Key.h"
#include "Instrument/LowestModes.h"
#include "Instrument/ObjectSource.h"
#include "Instrument/Preset.h"
#include "Instrument/Stage.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace idiophone {

/// Maximum of modes of all slots together. Each slot has its own bank, with half a kilobyte per
/// mode. Without this limit, a small file on 128 keys could use any amount of memory.
inline constexpr std::size_t maximumModesOfSlots = std::size_t{1} << 21;
/// Keys outside the preset's own play only if all keys together have at most this many modes: 256
/// MiB.
inline constexpr std::size_t maximumModesOfResizedKeys = std::size_t{1} << 19;
/// Maximum of slots. Each uses as much memory as thirty more modes.
inline constexpr std::size_t maximumSlots = std::size_t{1} << 16;

/// Fails if there are too many slots or modes. `ofWhat` names their owner in the error: a key map's
/// object ("'plate'"), a scene or a file. `played` names the slots.
Result<void> boundedSlots(std::span<const SynthesiserSlot> slots,
                          const std::string& ofWhat,
                          const char* played = "keys");

class Instrument {
public:
    /// Loads the objects that the key map names. The error names the object or the setting at
    /// fault. More modes than `maximumModesOfSlots` are an error.
    static Result<std::shared_ptr<const Instrument>> build(const KeyMap& keyMap,
                                                           ObjectSource& objects);

    /// Builds an instrument for a key map of kind `scene`: keys move bodies on a stage, which has a
    /// slot for each object. `slotOfKey` is the slot that shows and holds a note, −1 if the note
    /// does nothing.
    static std::shared_ptr<const Instrument> onStage(KeyMap keyMap,
                                                     std::vector<SynthesiserSlot> slots,
                                                     const std::array<int, 128>& slotOfKey,
                                                     std::shared_ptr<const Stage> stage);

    /// Returns a number from 1 on, unique among the instruments of the process. Threads that do not
    /// keep an instrument alive identify it by its number, because addresses are reused.
    std::uint64_t serialNumber() const { return serial; }

    const KeyMap& keyMap() const { return map; }
    std::span<const SynthesiserSlot> slots() const { return synthesiserSlots; }
    /// Returns all that a note plays: one key, or in a kit one for each part. Without an object it
    /// is a silent key.
    std::span<const Key> keysOf(int midiNote) const {
        const auto note = static_cast<std::size_t>(midiNote & 127);
        return std::span(keys).subspan(firstKeys[note], firstKeys[note + 1] - firstKeys[note]);
    }
    /// Returns the first of them, which stands for the note where one object must.
    const Key& key(int midiNote) const { return keysOf(midiNote).front(); }
    /// Returns the mallet for strikes on a slot without a key: its key's, if it has one.
    const KeyMallet& mallet(std::size_t slot) const { return mallets[slot]; }
    /// Returns the kit's part that plays the slot, or null.
    const KitPart* part(std::size_t slot) const { return parts[slot]; }
    /// Returns the object's name in the key map; empty on a stage.
    const std::string& objectName(std::size_t slot) const { return slotNames[slot]; }
    const LowestModes& lowestModes(std::size_t slot) const { return lowestModesOfSlots[slot]; }
    /// Returns whether a slot and all vertices of a point on its object exist.
    bool has(std::size_t slot, const StrikePoint& point) const;

    /// Returns the stage whose bodies the notes move in place of mallets, or null.
    const std::shared_ptr<const Stage>& stage() const { return ownStage; }
    /// Returns whether the slot has its key's pitch. Otherwise several keys share it, or it is a
    /// zone's.
    bool followsKey(std::size_t slot) const { return followKeys[slot]; }
    /// Returns whether all keys' objects have their keys' pitches.
    bool keysHaveObjects() const;
    /// Returns whether the preset has its own object for the note.
    bool hasOwn(int midiNote) const { return key(midiNote).slot >= 0 && key(midiNote).isOwn; }

private:
    explicit Instrument(KeyMap keyMap);

    Result<void> addMap(ObjectSource& objects);
    Result<void> addParts(ObjectSource& objects);
    void describeSlots();

    std::uint64_t serial;
    KeyMap map;
    std::vector<SynthesiserSlot> synthesiserSlots;
    std::vector<std::string> slotNames;          ///< [slots]
    std::vector<Key> keys;                       ///< by note
    std::array<std::size_t, 129> firstKeys{};    ///< [notes + 1] indices into keys
    std::vector<KeyMallet> mallets;              ///< [slots]
    std::vector<const KitPart*> parts;           ///< [slots]
    std::vector<bool> followKeys;                ///< [slots]
    std::vector<LowestModes> lowestModesOfSlots; ///< [slots]
    std::shared_ptr<const Stage> ownStage;
};

} // namespace idiophone
