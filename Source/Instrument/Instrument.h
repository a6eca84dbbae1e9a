// An instrument ready to be played: its objects in memory and, for every MIDI note, the object and
// the place to strike. It is immutable, so any number of players share it.
#pragma once

#include "Instrument/KeyMallet.h"
#include "Instrument/LowestModes.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/Preset.h"
#include "Instrument/Stage.h"
#include "Instrument/StrikeStrip.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace idiophone {

/// The object, place and mallet of a MIDI note.
struct Key {
    int slot = -1;                            ///< −1: the note is silent
    std::shared_ptr<const StrikeStrip> strip; ///< the object's; null if the note is silent
    double along = 0.5;                       ///< place on the strip, 0 to 1
    KeyMallet mallet = {};                    ///< difference from the chosen mallet
    /// False if the preset has no object for the key, so that the key plays a neighbour's.
    bool isOwn = true;
};

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
                                                           ObjectLibrary& library);

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
    const Key& key(int midiNote) const { return keys[static_cast<std::size_t>(midiNote & 127)]; }
    /// Returns the mallet for strikes on a slot without a key: its key's, if it has one.
    const KeyMallet& mallet(std::size_t slot) const { return mallets[slot]; }
    const LowestModes& lowestModes(std::size_t slot) const { return lowestModesOfSlots[slot]; }
    /// Returns whether a slot and all vertices of a point on its object exist.
    bool has(std::size_t slot, const StrikePoint& point) const;

    /// Returns the stage whose bodies the notes move in place of mallets, or null.
    const std::shared_ptr<const Stage>& stage() const { return ownStage; }
    /// Returns whether no two keys play the same object.
    bool keysHaveObjects() const;
    /// Returns whether the preset has its own object for the note.
    bool hasOwn(int midiNote) const { return key(midiNote).slot >= 0 && key(midiNote).isOwn; }

private:
    explicit Instrument(KeyMap keyMap);

    Result<void> buildBars(ObjectLibrary& library);
    Result<void> buildSingleObject(ObjectLibrary& library);
    void voice();
    void addResizedKeys();
    std::shared_ptr<const StrikeStrip> stripOf(const ModalObject& object);
    void describeSlots();

    std::uint64_t serial;
    KeyMap map;
    std::vector<SynthesiserSlot> synthesiserSlots;
    std::map<const ModalObject*, std::shared_ptr<const StrikeStrip>> strips;
    std::array<Key, 128> keys;
    std::vector<KeyMallet> mallets;              ///< [slots]
    std::vector<LowestModes> lowestModesOfSlots; ///< [slots]
    std::shared_ptr<const Stage> ownStage;
};

} // namespace idiophone
