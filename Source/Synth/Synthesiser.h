// Ringing objects mixed to one stream of samples: modal banks on the fixed grid, strikes at their
// sample, truncation by τ, quality scaling by S. Knows nothing of notes, meshes or hosts.
#pragma once

#include "Synth/CellOutput.h"
#include "Synth/ForceCell.h"
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

class SoundingObject;

/// Constructed and destroyed off the audio thread; every other member is for the audio thread, and
/// neither allocates, locks nor throws. Output is surface velocity in m/s (full scale 1), or what
/// `SynthesisSettings::radiation` makes of it; nothing is clipped.
class Synthesiser {
public:
    /// Cells handed over have `channels`, 1 or 2.
    Synthesiser(std::vector<SynthesiserSlot> slots, double sampleRateHz, std::size_t channels = 1);
    ~Synthesiser();
    Synthesiser(const Synthesiser&) = delete;
    Synthesiser& operator=(const Synthesiser&) = delete;

    /// Takes effect at the next `beginCell`.
    void setSettings(const SynthesisSettings& settings) noexcept;

    /// Extra fluid damping of one slot (a mute, a damper): everything it plays is multiplied by
    /// e^{−δt}, from the next `beginCell` on. 0 lifts it.
    void setDamping(std::size_t slot, double dampingPerSecond) noexcept;

    /// Frequencies of one slot times this (> 0), from the next `beginCell` on.
    void setFrequencyRatio(std::size_t slot, double ratio) noexcept;
    /// As set last; 1 where the slot does not exist.
    double frequencyRatio(std::size_t slot) const noexcept;

    /// What one slot is made of from the next `beginCell` on, whatever
    /// `SynthesisSettings::material` says; nothing: as that says. A material of which a figure is
    /// out of its range is ignored.
    void setMaterial(std::size_t slot, const std::optional<LiveMaterial>& material) noexcept;

    /// From the next `beginCell` on modes of one slot that are not 0 here ([modes of its object],
    /// or empty: none) are not heard: they fade out and in within 3 ms and ring on in between.
    void setSilencedModes(std::size_t slot, std::span<const std::uint8_t> silenced) noexcept;

    /// How far the tubes are open, 0 to 1, at the start and at the end of the cell begun next and
    /// of those after it: a gain of what tubes add, and of nothing else.
    void setTubeOpening(const TubeOpening& opening) noexcept;

    /// Advances by one cell and writes what rings into `cell`, over what was in it.
    void beginCell(const CellOutput& cell) noexcept;
    /// The same with a cell for each slot, for listeners to whom they are in different places.
    void beginCell(std::span<const CellOutput> cellsOfSlots) noexcept;

    /// Strikes a slot at `sampleInCell` (0 ≤ s < 64, may be fractional) of the cell begun last and
    /// adds the sound to the rest of it. Modes that the strike lifts above τ sound at once, within
    /// what the slot's share, an equal share or the unused rest of the budget allows; while a
    /// contact lasts the modes it found stay mixed. A contact time within 1 % of a lightly damped
    /// mode's period moves by 1 %. Returns false, and does nothing, where 64 contacts that last
    /// beyond this cell are already under way in this slot, where the slot, a shape row or the
    /// direction it is heard from does not exist, where `sampleInCell` or the duration is out of
    /// range, where a figure is not finite, or where a mode would move faster than 1e17 m/s.
    bool strike(std::size_t slot,
                const Strike& strike,
                double sampleInCell,
                const CellOutput& cell) noexcept;

    /// Whether `strike` would return false because 64 contacts are under way in this slot.
    bool contactsUsedUp(std::size_t slot) const noexcept;

    /// Presses on a slot throughout the cell begun last, in addition to whatever else does, and
    /// adds the sound to it. While a force lasts the modes that the budget allows stay mixed,
    /// however faint. A contact that ends wants a last cell whose force goes to 0, or it clicks.
    /// Returns false, and does nothing, where the slot or a shape row does not exist, a figure is
    /// not finite or a force larger than 1e12 N. What answers 1 N s with more than 1e17 m/s is
    /// silent.
    bool applyForce(std::size_t slot, const ForceCell& force, const CellOutput& cell) noexcept;

    /// Forgets all that rings, at once. The caller fades the output.
    void reset() noexcept;

    struct SlotStatus {
        float amplitude = 0;            ///< summed amplitude of its modes, m/s
        std::int32_t modesRinging = 0;  ///< above τ
        std::int32_t modesMixed = 0;    ///< of these, within its share of the budget
        std::int32_t channels = 0;      ///< in which it sounds; one is heard in both
        std::int32_t share = 0;         ///< of the budget: modes it was given, no more than ring
        std::int32_t groups = 0;        ///< of modes, after compression
        std::int32_t groupsAudible = 0; ///< of these, within the band and not silenced
    };
    /// As of the cell begun last.
    std::span<const SlotStatus> status() const noexcept;
    std::int64_t modesMixed() const noexcept;
    /// What is heard of a slot's modes, as of the cell begun last. Costs a pass over them. Nothing
    /// where the slot does not exist.
    void report(std::size_t slot, SoundingGroups& groups) const noexcept;
    const SynthesisSettings& settings() const noexcept;
    bool silent() const noexcept; ///< nothing rings and no contact is under way

    double sampleRateHz() const noexcept;
    std::size_t slotCount() const noexcept;

private:
    struct Implementation;

    template <class CellOf>
    void mixInto(CellOf cellOf) noexcept;

    std::unique_ptr<Implementation> implementation;
};

} // namespace idiophone
