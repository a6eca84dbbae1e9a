// SPDX-License-Identifier: Apache-2.0
// A resonator, one slot of the synthesiser: an object that sounds. It renders cells and takes
// strikes and forces; the budget comes from the synthesiser.
#pragma once

#include "Synth/ActiveModes.h"
#include "Synth/AmplitudeEnvelope.h"
#include "Synth/ContactSet.h"
#include "Synth/ForceResponses.h"
#include "Synth/GroupResidues.h"
#include "Synth/ModeGroups.h"
#include "Synth/PendingIncrements.h"
#include "Synth/PointShapes.h"
#include "Synth/SlotStatus.h"
#include "Synth/SoundingGroups.h"
#include "Synth/SynthesisSettings.h"
#include "Synth/SynthesiserSlot.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace idiophone {

/// The modes that an object may mix after a strike.
struct StrikeAllowance {
    std::int32_t modes = 0; ///< whatever the amplitude
    /// If not null: as many as an object of its amplitude got at the last ranking.
    const BudgetShares* ranking = nullptr;
    double advantage = 1; ///< factor of the amplitude in the ranking
};

/// Memory is reserved by the constructor; every other member is for the audio thread. The current
/// cell is the one begun last, or that of `moveTo`. States of active blocks hold at its start;
/// after `mix` they hold at its end.
class ModalResonator {
public:
    /// The slot has an object. `channels` is the channel count of the cells, 1 or 2. A resonator
    /// sounds in stereo from the first strike with far sound (`SynthesisSettings::radiation`) until
    /// it is silent again. Weights and seed: see ModeGroups. `scratch` has room for the slot's
    /// object; resonators on one thread share it. It and the envelope outlive this.
    ModalResonator(SynthesiserSlot slot,
                   ModeGroups::ModeWeights modeWeights,
                   std::uint32_t seed,
                   std::size_t channels,
                   double sampleRateHz,
                   SynthesisScratch& scratch,
                   AmplitudeEnvelope& envelope);
    ModalResonator(const ModalResonator&) = delete;
    ModalResonator& operator=(const ModalResonator&) = delete;

    void setDamping(double dampingPerSecond) noexcept {
        if (dampingPerSecond >= 0 && std::isfinite(dampingPerSecond))
            request(requestedDamping, dampingPerSecond);
    }
    void setFrequencyRatio(double ratio) noexcept {
        if (ratio > 0 && std::isfinite(ratio))
            request(requestedFrequencyRatio, ratio);
    }
    double frequencyRatio() const noexcept { return requestedFrequencyRatio; }
    /// Replaces the settings' material, or stops replacing it. All values must be in range.
    void setMaterial(const std::optional<LiveMaterial>& material) noexcept {
        request(requestedMaterial, material);
    }
    /// Mutes modes with values ≠ 0 from the next `beginCell` on ([modes of the object], or empty:
    /// none). They fade out and in, and ring on unmixed in between.
    void setSilencedModes(std::span<const std::uint8_t> silenced) noexcept;

    /// Returns whether something was set that `beginCell` or `catchUp` has not applied yet.
    bool hasNewControls() const noexcept { return controlsChanged; }

    /// Returns whether modes may have to form other groups. A sounding object keeps its groups,
    /// with new poles, until `letRegroup`.
    bool wantsToRegroup() const noexcept { return controlsChanged || groups.areOutdated(); }
    /// Lets the next `beginCell` group the modes anew. A strike on a silent object does so itself
    /// while `SynthesisScratch::modesToRegroup` lasts.
    void letRegroup() noexcept { mayRegroup = true; }
    /// Applies settings and groups the modes at once, at the end of cell `index`. Call it before
    /// anything sounds, since construction or `reset`.
    void settle(const SynthesisSettings& settings, std::int64_t index) noexcept {
        moveTo(index);
        output.restartDamper(index);
        letRegroup();
        applySettings(settings);
    }

    /// Moves to the grid point of cell `index`: applies pending settings and drops modes at t_c
    /// (Raghuvanshi & Lin 2006, eq. 14). Returns false if it is idle. Cells in which it is idle,
    /// and nothing is set, need no call.
    bool
    beginCell(std::int64_t index, const SynthesisSettings& settings, bool settingsChanged) noexcept;
    /// Moves an idle resonator to a cell.
    void moveTo(std::int64_t index) noexcept { cellIndex = index; }
    /// Lets resting modes above τ join the next `mix`; call it after `moveTo`.
    void wake() noexcept;
    /// Lets an idle resonator fall silent.
    void fallSilent() noexcept { active.forgetResting(); }

    /// Returns the demand for quality scaling; call it after `beginCell`. It includes modes held by
    /// a contact. While modes rest, the amplitude is a bound.
    ModeDemand demand() const noexcept {
        const auto [amplitude, modes] = active.demand();
        return {active.restRinging() ? envelope.amplitude() : amplitude, modes};
    }
    /// Sets the envelope to the present states, for a ranking. The next `mix` chooses modes anew.
    void measure() noexcept;

    /// Mixes the strongest `allowance` modes into the cell. During a contact its modes stay,
    /// whatever the allowance, as its forced part was summed over them.
    void mix(std::int32_t allowance, const CellOutput& cell) noexcept;

    /// Call it after `mix`, before a strike. Applies what was set since `beginCell`: to the strike
    /// at once, and to ringing modes from the next grid point, where their states hold. During a
    /// contact, all of it waits for the next cell.
    void catchUp(const SynthesisSettings& settings) noexcept;

    /// Adds a strike to the rest of the current cell. `allowed` bounds the number of modes mixed
    /// after it. An idle resonator that may mix none stays idle if the contact ends in this cell. A
    /// contact shorter than two samples is an impulse. Returns false and does nothing if no contact
    /// is free or the strike is not valid for this object.
    bool strike(const Strike& strike,
                double sampleInCell,
                const StrikeAllowance& allowed,
                const CellOutput& cell) noexcept;

    bool contactsUsedUp() const noexcept { return contacts.full(); }

    /// Applies a cell of continuous force. Call it after `mix` of the same cell, any number of
    /// times. During a force the resonator mixes as many of its modes as `allowance` permits, and
    /// drops none.
    bool
    applyForce(const ForceCell& force, std::int32_t allowance, const CellOutput& cell) noexcept {
        HeardForce heard;
        const bool isValid = beginForce(force, allowance, heard);
        if (isValid) {
            forces.add(heard, force, 0, cellSamples, cell);
            forces.moveAsHeard(force);
        }
        return isValid;
    }

    /// Begins a cell of force whose samples become known in its course, and computes how it will be
    /// heard. Otherwise as `applyForce`.
    bool beginForce(const ForceCell& force, std::int32_t allowance, HeardForce& heard) noexcept;
    void hearForce(const HeardForce& heard,
                   const ForceCell& force,
                   std::size_t from,
                   std::size_t count,
                   const CellOutput& cell) const noexcept {
        forces.add(heard, force, from, count, cell);
    }
    /// Moves the states by the whole cell of a force that has begun, before the next cell.
    void endForce(const ForceCell& force) noexcept { forces.move(force); }

    /// Finds the modes that yield most at a place, with their poles in the current cell. Returns
    /// false and does nothing if the place is not valid for this object.
    bool findModes(const ForcePlace& place, PointModes& modes) noexcept {
        if (!isOn(object, place))
            return false;
        prepareBank();
        forces.findModes(place, listening, groups.starts(), modes);
        return true;
    }

    /// Silences everything at once. Touches the states of ringing blocks only.
    void reset() noexcept;

    /// Reports the groups of modes in a cell, the current one unless it is idle.
    void report(SoundingGroups& groups, std::int64_t cell) const noexcept;

    /// Returns whether a cell needs neither `beginCell` nor `mix`.
    bool idle() const noexcept {
        return active.blocks().none() && !contacts.sounding() && !output.fading() &&
               !increments.pending();
    }
    /// Returns whether modes ring that the budget leaves out altogether.
    bool asleep() const noexcept { return idle() && active.restRinging(); }
    bool silent() const noexcept {
        return active.blocks().none() && !contacts.sounding() && !output.fading() &&
               !active.restRinging();
    }
    std::size_t modeCount() const noexcept { return object.modeCount(); }
    /// Number of mixed modes, including those that strikes have added since `mix`.
    std::int32_t modesMixed() const noexcept { return active.modes().mixedCount(); }
    /// Returns all but the share, which the budget gives.
    SlotStatus status() const noexcept {
        const auto [amplitude, modes] = demand();
        return {.amplitude = static_cast<float>(amplitude),
                .modesRinging = modes,
                .modesMixed = modesMixed(),
                .channels = static_cast<std::int32_t>(bank.channels()),
                .groups = static_cast<std::int32_t>(bank.size()),
                .groupsAudible = static_cast<std::int32_t>(bank.poles().audibleCount())};
    }

private:
    void applySettings(const SynthesisSettings& settings) noexcept;
    void movePoles(bool regroups) noexcept;
    void clearOldBank() noexcept;
    template <class Value>
    void request(Value& requested, const Value& wanted) noexcept {
        controlsChanged = controlsChanged || wanted != requested;
        requested = wanted;
    }
    void prepareBank() noexcept;
    void widen(double farShare) noexcept;
    bool strikeAsleep(const Contact& contact, const CellOutput& cell) noexcept;

    std::int64_t cellIndex = -1; ///< the current cell
    bool controlsChanged = true;
    bool mayRegroup = false; ///< by the next `applySettings`
    SynthesisScratch& scratch;
    AmplitudeEnvelope& envelope;

    SynthesiserSlot slot;
    const ModalObject& object; ///< of the slot
    std::size_t outputChannels;
    double requestedDamping = 0;
    double requestedFrequencyRatio = 1;
    std::optional<LiveMaterial> requestedMaterial; ///< empty: the settings'
    Listening listening;                           ///< for strikes from now on
    double sizeNow = 1; ///< size over the reference size, for strikes from now on
    /// The bank holds sound from before a reset. It is cleared before its next use, because it may
    /// be large and all resonators are reset at once.
    bool bankIsOld = false;

    ModalBank bank;
    BankOutput output;
    ModeGroups groups;
    GroupResidues residues;
    ActiveModes active;
    PendingIncrements increments;
    ContactSet contacts;
    ForceResponses forces;
};

} // namespace idiophone
