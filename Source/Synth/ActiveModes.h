// The modes of a bank that ring (above τ) and those that are mixed, which the budget and contacts
// decide. Blocks without any of them rest, and so do blocks whose modes the budget leaves out.
#pragma once

#include "Synth/ActiveBlocks.h"
#include "Synth/BankOutput.h"
#include "Synth/ModeBits.h"
#include "Synth/ModeGroups.h"
#include "Synth/QualityScaling.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace idiophone {

/// Memory is reserved by the constructor; every other member is for the audio thread. `grid` is the
/// grid point where the states of active blocks hold.
class ActiveModes {
public:
    ActiveModes(ModalBank& bank, BankOutput& output, SynthesisScratch& scratch);

    const ActiveBlocks& blocks() const noexcept { return activeBlocks; }
    std::span<const ModeRun> mixedRuns() const noexcept { return runs; }
    std::int32_t mixedCount() const noexcept { return static_cast<std::int32_t>(mixed.size()); }
    bool allMixed() const noexcept { return mixed.size() == bank.poles().audibleCount(); }
    /// Returns the amplitude of the active modes and the number of ringing ones that `survey`
    /// found.
    ModeDemand demand() const noexcept { return demanded; }
    /// Returns whether ringing modes rest because the budget leaves them out.
    bool restRinging() const noexcept { return restingModes > 0; }
    /// Counts the changes of the mixed modes.
    std::uint64_t version() const noexcept { return changes; }

    bool isMixed(std::size_t g) const noexcept { return isSet(flags[g / modeBlock].mixed, g); }
    bool rings(std::size_t g) const noexcept { return isSet(flags[g / modeBlock].rings, g); }

    double tau() const noexcept { return tauPascals; }
    void setTau(double pascals) noexcept { tauPascals = pascals; }
    /// Returns whether any mode is above τ, audible or not. With other poles it may be audible.
    bool holdsAboveTau() const noexcept;

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

    /// Mixes the modes that increments of these energies [padded size] lift above τ, at most
    /// `allowance` modes in all, the loudest by `loudness`. During a contact, ringing modes that
    /// the budget left out cannot join, as their forced part would step. Returns the modes that
    /// have joined, valid until the next call on any resonator.
    std::span<const ModeRun> joinStruck(const float* energies,
                                        const float* loudness,
                                        std::int32_t allowance,
                                        bool duringContact,
                                        std::int64_t grid) noexcept {
        return join(energies, tauEnergy(), loudness, allowance, duringContact, grid);
    }
    /// Does the same for all audible modes.
    std::span<const ModeRun>
    joinAll(std::int32_t allowance, bool duringContact, std::int64_t grid) noexcept {
        return join(bank.poles().audibleWeights(), 0, bank.energies(), allowance, duringContact,
                    grid);
    }

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
    /// The modes of one block, one bit each.
    struct Flags {
        std::uint16_t rings = 0;
        std::uint16_t mixed = 0;
    };

    float tauEnergy() const noexcept { return static_cast<float>(tauPascals * tauPascals); }
    void retireBlocks(bool evenRinging, std::int64_t grid) noexcept;
    void wakeContenders(std::int32_t allowance, std::int64_t grid) noexcept;
    void countResting(float threshold) noexcept;
    void selectStrongest(std::size_t maximum) noexcept;
    void listMixed() noexcept;
    EnergySurvey surveyAll(const float* energies, float threshold) noexcept;
    std::span<const ModeRun> join(const float* energies,
                                  float threshold,
                                  const float* loudness,
                                  std::int32_t allowance,
                                  bool duringContact,
                                  std::int64_t grid) noexcept;
    void admit(std::size_t g, std::int64_t grid) noexcept;
    void handOnFlags(const ModeGroups& groups) noexcept;
    void fadeChanges(std::span<const ModeShare> shares) noexcept;

    ModalBank& bank;
    BankOutput& output;
    SynthesisScratch& scratch;
    ActiveBlocks activeBlocks;
    std::vector<Flags> flags;        ///< of every block
    std::vector<std::int32_t> mixed; ///< ascending
    std::vector<ModeRun> runs;       ///< of `mixed`
    static constexpr std::int32_t noChoice = -1;
    static constexpr std::int32_t allModes = std::numeric_limits<std::int32_t>::max();
    std::int32_t chosenFor = allModes; ///< the allowance that decided the mixed modes
    std::int32_t restingModes = 0;     ///< ringing modes in resting blocks
    ModeDemand demanded;
    double tauPascals = 0; ///< at least the floor below which states become 0
    std::uint64_t changes = 0;
};

} // namespace idiophone
