// SPDX-License-Identifier: Apache-2.0
// The slots that move cell by cell, and the number of modes that each may mix. If the mode budget
// does not suffice, the quietest objects sleep: nothing of theirs is moved until they are louder
// than others or the budget suffices again.
#pragma once

#include "Synth/ModalResonator.h"
#include "Synth/SlotStatus.h"

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace idiophone {

/// Memory is reserved by the constructor; every other member is for the audio thread. At first all
/// slots are awake, to take their settings. While the budget suffices no object sleeps or is
/// limited. From the cell on in which the demands exceed it, the objects are ranked once a period
/// of `AmplitudeEnvelope`.
class AwakeSlots {
public:
    /// `objects`, one for each slot, and their `envelopes` outlive this.
    AwakeSlots(std::deque<ModalResonator>& objects, std::span<AmplitudeEnvelope> envelopes);

    /// Moves the awake slots to the next cell and shares the budget.
    void beginCell(const SynthesisSettings& settings, bool settingsChanged) noexcept;
    std::span<const std::int32_t> list() const noexcept { return awake; } ///< ascending
    std::int32_t share(std::size_t slot) const noexcept { return shares[slot]; }
    std::int64_t cell() const noexcept { return cellIndex; } ///< the current cell
    /// Lets all slots sleep; call it while nothing sounds and the objects have their settings.
    void letAllSleep() noexcept;
    /// Wakes a slot for the next cell.
    void wake(std::size_t slot) noexcept;

    /// Call it after the awake slots are mixed.
    void report() noexcept;
    std::span<const SlotStatus> status() const noexcept { return statusOf; } ///< by `report`

    /// Returns how many modes a slot may mix after a strike. A sleeping object gets none unless it
    /// is then as loud as those that have a share.
    StrikeAllowance strikeAllowance(std::size_t slot) const noexcept;
    /// Returns how many modes a slot may mix during a force.
    std::int32_t forceAllowance(std::size_t slot) const noexcept;
    /// Takes in that a strike or force has acted on a slot, which has mixed `modesBefore` modes.
    void update(std::size_t slot, std::int32_t modesBefore) noexcept;

    /// Call it after a reset of the objects.
    void reset() noexcept;

private:
    std::int64_t dropIdle(const SynthesisSettings& settings, bool settingsChanged) noexcept;
    void rank(const SynthesisSettings& settings, bool periodBegins) noexcept;
    void listRinging(double tauPascals, bool periodBegins) noexcept;
    void limit(std::int64_t modes) noexcept;
    std::int32_t modesWanted(std::size_t slot) const noexcept;
    double advantage(std::size_t slot) const noexcept;
    std::int32_t ownAllowance(std::size_t slot) const noexcept;

    std::deque<ModalResonator>& objects;
    std::span<AmplitudeEnvelope> envelopes; ///< of every slot
    std::vector<std::int32_t> awake;        ///< ascending
    std::vector<char> isAwake;              ///< of every slot
    std::vector<SlotStatus> statusOf;       ///< of every slot
    std::int64_t cellIndex = -1;
    std::int64_t budget = 0;   ///< in modes
    std::int64_t mixedNow = 0; ///< including modes that strikes have added

    BudgetShares division;            ///< of the last ranking
    std::vector<std::int32_t> shares; ///< of every slot
    std::vector<std::int32_t> ranked; ///< slots that ring, awake or not
    std::vector<ModeDemand> demands;  ///< of `ranked`
    int cellsToRanking = 0;
};

} // namespace idiophone
