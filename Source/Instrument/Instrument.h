// An instrument ready to be played: its objects in memory and, for every MIDI note, which of them
// to strike and where. Immutable, so any number of players share it.
#pragma once

#include "Instrument/ObjectLibrary.h"
#include "Instrument/Preset.h"
#include "Instrument/Stage.h"
#include "Instrument/StrikeStrip.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace idiophone {

/// What a MIDI note plays.
struct Key {
    int slot = -1;          ///< −1: the note is silent
    int strip = 0;          ///< index into Instrument::strips
    double along = 0.5;     ///< its own place on the strip
    double malletScale = 1; ///< size of its mallet: time × this, impulse × this³
    /// False if the preset has no object for the key, which then plays a neighbour's.
    bool isOwn = true;
};

/// Of all slots together: each has a bank of its own, of half a kilobyte a mode, so that a small
/// file on 128 keys could take any memory.
inline constexpr std::size_t mostModesOfSlots = std::size_t{1} << 21;
/// Keys beside a preset's own play only where all keys together have no more modes than this: a
/// quarter of a gigabyte.
inline constexpr std::size_t mostModesOfResizedKeys = std::size_t{1} << 19;
/// And each slot takes as much again as thirty modes.
inline constexpr std::size_t mostSlots = std::size_t{1} << 16;

/// Refuses more slots, or slots of more modes. The error says of what they are: a key map's object
/// ("'plate'"), a scene, a file; and on all of which it has too many.
Result<void> boundedSlots(std::span<const SynthesiserSlot> slots,
                          const std::string& ofWhat,
                          const char* played = "keys");

class Instrument {
public:
    /// Loads what the preset names. The error names the object or the setting at fault; one fault
    /// is more modes than `mostModesOfSlots`.
    static Result<std::shared_ptr<const Instrument>> build(const KeyMap& keyMap,
                                                           ObjectLibrary& library);

    /// Of a key map of kind `scene`: keys set bodies in motion on a stage, which has a slot for
    /// each object. `slotOfKey` is what a note is shown and held by, −1 where it does nothing.
    static std::shared_ptr<const Instrument> onStage(KeyMap keyMap,
                                                     std::vector<SynthesiserSlot> slots,
                                                     const std::array<int, 128>& slotOfKey,
                                                     std::shared_ptr<const Stage> stage);

    /// Another one for every instrument of the process, from 1 on. Threads that do not keep an
    /// instrument alive know it by this: another one may come to lie at its address.
    std::uint64_t serialNumber() const { return serial; }

    const KeyMap& keyMap() const { return map; }
    std::span<const SynthesiserSlot> slots() const { return synthesiserSlots; }
    const Key& key(int midiNote) const { return keys[static_cast<std::size_t>(midiNote & 127)]; }
    const StrikeStrip& strip(const Key& key) const {
        return strips[static_cast<std::size_t>(key.strip)];
    }

    /// What its notes set in motion instead of mallets, or null.
    const std::shared_ptr<const Stage>& stage() const { return ownStage; }
    /// No two keys play one object.
    bool keysHaveObjects() const;
    /// Whether a note plays an object that the preset has for it.
    bool hasOwn(int midiNote) const { return key(midiNote).slot >= 0 && key(midiNote).isOwn; }

private:
    explicit Instrument(KeyMap keyMap);

    Result<void> buildBars(ObjectLibrary& library);
    Result<void> buildSingleObject(ObjectLibrary& library);
    void addResizedKeys();

    std::uint64_t serial;
    KeyMap map;
    std::vector<SynthesiserSlot> synthesiserSlots;
    std::vector<StrikeStrip> strips;
    std::array<Key, 128> keys;
    std::shared_ptr<const Stage> ownStage;
};

} // namespace idiophone
