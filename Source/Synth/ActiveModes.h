// SPDX-License-Identifier: Apache-2.0
// The modes of a bank that ring (above τ) and those that are mixed, which the budget and contacts
// decide. Blocks without any of them rest, and so do blocks whose modes the budget leaves out.
#pragma once

#include "Synth/ActiveBlocks.h"
#include "Synth/BankOutput.h"
#include "Synth/ModeFlags.h"
#include "Synth/QualityScaling.h"

#include <cstdint>
#include <limits>
#include <span>

namespace idiophone {

/// Memory is reserved by the constructor; every other member is for the audio thread. `grid` is the
/// grid point where the states of active blocks hold.
class ActiveModes {
public:
    ActiveModes(ModalBank& bank, BankOutput& output, SynthesisScratch& scratch);

    const ActiveBlocks& blocks() const noexcept { return activeBlocks; }
    const ModeFlags& modes() const noexcept { return flags; }
    std::span<const ModeRun> mixedRuns() const noexcept { return flags.runs(); }
    bool allMixed() const noexcept { return flags.mixed().size() == bank.poles().audibleCount(); }
    /// Returns the amplitude of the active modes and the number of ringing ones that `survey`
    /// found.
    ModeDemand demand() const noexcept { return demanded; }
    /// Returns whether ringing modes rest because the budget leaves them out.
    bool restRinging() const noexcept { return restingModes > 0; }

    double tau() const noexcept { return tauPascals; }
    float tauEnergy() const noexcept { return static_cast<float>(tauPascals * tauPascals); }
    void setTau(double pascals) noexcept { tauPascals = pascals; }

    /// How a survey may change the set of ringing modes.
    enum class Change { any, joinOnly, none };
    /// Finds the modes above τ at t_c of Raghuvanshi & Lin 2006, eq. 14.
    void survey(Change allowed) noexcept;
    /// Mixes the strongest `allowance` ringing modes. If they are fewer than all, they stay until a
    /// mode starts or stops ringing, or `reconsider`. Call it after `survey`.
    void choose(std::int32_t allowance, std::int64_t grid) noexcept;
    /// Lets the next `choose` compare all ringing modes again.
    void reconsider() noexcept { chosenFor = noChoice; }
    /// Activates all blocks that hold something above τ; the next survey finds the ringing modes.
    void wake(std::int64_t grid) noexcept;
    /// Stops counting resting modes as ringing, because they have fallen below τ.
    void forgetResting() noexcept { countResting(largestEnergy); }

    /// Modes that could join the mix: those with `energies` [padded size] above the threshold, the
    /// loudest by `loudness` first.
    struct Candidates {
        const float* energies;
        float threshold;
        const float* loudness;
    };
    /// Mixes audible candidates, at most `allowance` modes in all. During a contact, ringing modes
    /// that the budget left out cannot join, as their forced part would step. Returns the modes
    /// that have joined, valid until the next call on any resonator.
    std::span<const ModeRun> join(const Candidates& candidates,
                                  std::int32_t allowance,
                                  bool duringContact,
                                  std::int64_t grid) noexcept;

    /// Call it before adding to the states at a grid point.
    void bringRestingUpToDate(std::int64_t grid) noexcept {
        activeBlocks.bringRestingUpToDate(grid);
    }
    /// Call it after adding to the states.
    void listRinging() noexcept;
    /// Does the same if all blocks rest, and lets them rest.
    void listResting() noexcept;

    /// Fades out newly inaudible modes, still with their old poles: beyond the band the new ones
    /// would alias.
    void fadeInaudible(const ModeGroups& groups, std::int64_t grid) noexcept;
    /// Changes the modes of the bank to `groups`, which have just changed, and keeps their sound.
    /// Each mode takes a fixed share of its group's state along, and modes that join a group add
    /// up, so that no velocity steps. Move the bank's poles next.
    void regroup(const ModeGroups& groups, std::int64_t grid) noexcept;

    void reset() noexcept;

private:
    void retireBlocks(bool evenRinging, std::int64_t grid) noexcept;
    void wakeContenders(std::int32_t allowance, std::int64_t grid) noexcept;
    void countResting(float threshold) noexcept;
    void selectStrongest(std::size_t maximum) noexcept;
    EnergySurvey surveyAll(const float* energies, float threshold) noexcept;
    void admit(std::size_t g, std::int64_t grid) noexcept;
    void fadeChanges(std::span<const ModeShare> shares) noexcept;

    ModalBank& bank;
    BankOutput& output;
    SynthesisScratch& scratch;
    ActiveBlocks activeBlocks;
    ModeFlags flags;
    static constexpr std::int32_t noChoice = -1;
    static constexpr std::int32_t allModes = std::numeric_limits<std::int32_t>::max();
    std::int32_t chosenFor = allModes; ///< the allowance that decided the mixed modes
    std::int32_t restingModes = 0;     ///< ringing modes in resting blocks
    ModeDemand demanded;
    double tauPascals = 0; ///< at least the floor below which states become 0
};

} // namespace idiophone
