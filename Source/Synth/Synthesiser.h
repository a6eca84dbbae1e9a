// SPDX-License-Identifier: Apache-2.0
// Mixes ringing objects to one stream of samples: modal banks on the fixed grid, strikes at their
// sample, truncation by τ, quality scaling by S. It knows neither notes, meshes nor hosts.
#pragma once

#include "Synth/CellOutput.h"
#include "Synth/ForceCell.h"
#include "Synth/HeardForce.h"
#include "Synth/SlotStatus.h"
#include "Synth/SoundingGroups.h"
#include "Synth/Strike.h"
#include "Synth/SynthesisSettings.h"
#include "Synth/SynthesiserSlot.h"
#include "Synth/TubeOpening.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

class ModalResonator;
struct PointModes;

/// Constructed and destroyed off the audio thread; every other member is for the audio thread and
/// neither allocates, locks nor throws. The output is surface velocity in m/s (full scale 1), or
/// radiated pressure as `SynthesisSettings::radiation` asks. Nothing is clipped. The current cell
/// is the one begun last.
class Synthesiser {
public:
    /// All cells have `channels` channels, 1 or 2.
    Synthesiser(std::vector<SynthesiserSlot> slots, double sampleRateHz, std::size_t channels = 1);
    ~Synthesiser();
    Synthesiser(const Synthesiser&) = delete;
    Synthesiser& operator=(const Synthesiser&) = delete;

    /// Takes effect at the next `beginCell`. After the first cell a change regroups the modes of a
    /// few slots in each cell; until its turn a slot keeps its groups, with new poles.
    void setSettings(const SynthesisSettings& settings) noexcept;
    /// Applies the settings to all slots at once, groups included. The first cell, strike or force
    /// after construction or `reset` does so otherwise. Changes after it are spread over cells,
    /// also before the first cell. Takes time with the number of modes. Nothing may sound.
    void settle() noexcept;

    /// Sets an extra fluid damping of one slot (a mute, a damper). From the next `beginCell` on,
    /// all its sound is multiplied by e^{−δt}. 0 lifts it.
    void setDamping(std::size_t slot, double dampingPerSecond) noexcept;

    /// Multiplies the frequencies of one slot by `ratio` > 0 from the next `beginCell` on.
    void setFrequencyRatio(std::size_t slot, double ratio) noexcept;
    /// Returns the ratio set last, or 1 if the slot does not exist.
    double frequencyRatio(std::size_t slot) const noexcept;

    /// Sets the material of one slot from the next `beginCell` on, instead of
    /// `SynthesisSettings::material`. If empty, the settings' material applies again. A material
    /// with a value out of range is ignored.
    void setMaterial(std::size_t slot, const std::optional<LiveMaterial>& material) noexcept;

    /// Mutes modes of one slot with values ≠ 0 from the next `beginCell` on ([modes of its object],
    /// or empty: none). They fade out and in within 3 ms and ring on unheard in between.
    void setSilencedModes(std::size_t slot, std::span<const std::uint8_t> silenced) noexcept;

    /// Sets how far the tubes are open, 0 to 1, at the start and end of the next cell and of those
    /// after it. This gain acts on the tubes' part of the sound only.
    void setTubeOpening(const TubeOpening& opening) noexcept;

    /// Moves on by one cell and overwrites `cell` with the sound of ringing modes.
    void beginCell(const CellOutput& cell) noexcept;
    /// Moves on by one cell with a separate cell for each slot, for listeners that place the slots
    /// apart.
    void beginCell(std::span<const CellOutput> cellsOfSlots) noexcept;

    /// Strikes a slot at `sampleInCell` (0 ≤ s < 64, may be fractional) of the current cell and
    /// adds the sound to the rest of the cell. Modes that the strike lifts above τ sound at once,
    /// if the budget permits: the slot's share, an equal share, or the unused rest. During a
    /// contact its modes stay mixed. A contact time within 1 % of a lightly damped mode's period
    /// changes by up to 3 %.
    ///
    /// Returns false and does nothing if 64 contacts that outlast this cell are under way in this
    /// slot; if the slot, a shape row or the far direction does not exist; if `sampleInCell` or the
    /// duration is out of range; if a value is not finite; or if a mode would move faster than 1e17
    /// m/s.
    bool strike(std::size_t slot,
                const Strike& strike,
                double sampleInCell,
                const CellOutput& cell) noexcept;

    /// Returns whether `strike` would return false because 64 contacts are under way in this slot.
    bool contactsUsedUp(std::size_t slot) const noexcept;

    /// Presses on a slot throughout the current cell, in addition to other forces, and adds the
    /// sound. During a force the modes that the budget permits stay mixed, however faint. End a
    /// force with a cell in which it falls to 0; otherwise it clicks. Returns false and does
    /// nothing if the slot or a shape row does not exist, a value is not finite or a force is above
    /// 1e12 N. A response above 1e17 m/s to 1 N s is silent.
    bool applyForce(std::size_t slot, const ForceCell& force, const CellOutput& cell) noexcept;

    /// Finds the modes of a slot that yield most at a place, as a force in the current cell meets
    /// them: at most `PointModes::capacity`. Directions are unit vectors or zero. Costs little if
    /// `modes` hold them already. Returns false and does nothing if the slot or a shape row does
    /// not exist or a value is not finite.
    bool findModes(std::size_t slot, const ForcePlace& place, PointModes& modes) noexcept;

    /// Begins, within the current cell, a force whose samples become known in its course, and
    /// computes how it will be heard. Returns false as `applyForce` does. The slot must exist in
    /// `hearForce` and `endForce`.
    bool beginForce(std::size_t slot, const ForceCell& force, HeardForce& heard) noexcept;
    /// Adds `count` samples of its sound from sample `from` on. The force's later samples are not
    /// read.
    void hearForce(std::size_t slot,
                   const HeardForce& heard,
                   const ForceCell& force,
                   std::size_t from,
                   std::size_t count,
                   const CellOutput& cell) const noexcept;
    /// Lets the whole force act on the modes; call it before the next cell.
    void endForce(std::size_t slot, const ForceCell& force) noexcept;

    /// Silences everything at once. The caller fades the output. From the next `beginCell` on the
    /// slots sound bit for bit as new ones with the same settings.
    void reset() noexcept;

    using SlotStatus = idiophone::SlotStatus;
    /// Returns the status as of the current cell.
    std::span<const SlotStatus> status() const noexcept;
    std::int64_t modesMixed() const noexcept;
    /// Reports a slot's groups of modes as heard in the current cell. Costs a pass over them. Does
    /// nothing if the slot does not exist.
    void report(std::size_t slot, SoundingGroups& groups) const noexcept;
    const SynthesisSettings& settings() const noexcept;
    bool silent() const noexcept;                 ///< nothing rings and no contact is under way
    bool silent(std::size_t slot) const noexcept; ///< in this slot, or it does not exist

    double sampleRateHz() const noexcept;
    std::size_t slotCount() const noexcept;

private:
    struct Implementation;

    template <class CellOf>
    void mixInto(CellOf cellOf) noexcept;

    std::unique_ptr<Implementation> implementation;
};

} // namespace idiophone
