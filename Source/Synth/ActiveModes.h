// The modes of a bank that ring (above τ) and those that are mixed (heard), which the budget and
// contacts decide. Blocks without any of them rest in closed form.
#pragma once

#include "Synth/BankOutput.h"
#include "Synth/ModeBits.h"
#include "Synth/ModeGroups.h"
#include "Synth/QualityScaling.h"

#include <cstdint>
#include <span>
#include <vector>

namespace idiophone {

/// Memory is reserved by the constructor; every other member is for the audio thread. `grid` is the
/// grid point where the states of active blocks hold.
class ActiveModes {
public:
    ActiveModes(ModalBank& bank, BankOutput& output, SynthesisScratch& scratch);

    bool none() const noexcept { return activeBlocks.empty(); }
    std::span<const std::int32_t> blocks() const noexcept { return activeBlocks; } ///< ascending
    std::span<const ModeRun> mixedRuns() const noexcept { return runs; }
    std::int32_t mixedCount() const noexcept { return static_cast<std::int32_t>(mixed.size()); }
    bool allMixed() const noexcept { return mixed.size() == bank.poles().audibleCount(); }
    /// Returns the demand for quality scaling that `survey` found.
    ModeDemand demand() const noexcept { return demanded; }
    /// Counts the changes of the mixed modes.
    std::uint64_t version() const noexcept { return changes; }

    bool isMixed(std::size_t g) const noexcept { return isSet(states[g / modeBlock].mixed, g); }
    bool rings(std::size_t g) const noexcept { return isSet(states[g / modeBlock].rings, g); }
    /// Returns the current amplitude; a resting block has decayed since it came to rest.
    float amplitude(std::size_t g, std::int64_t grid) const noexcept;

    double tau() const noexcept { return tauPascals; }
    void setTau(double pascals) noexcept { tauPascals = pascals; }
    /// Returns whether any mode is above τ, audible or not. An inaudible mode may be heard with
    /// other poles.
    bool holdsAboveTau() const noexcept;

    /// How a survey may change the set of ringing modes.
    enum class Change { any, joinOnly, none };
    /// Finds the modes above τ at t_c of Raghuvanshi & Lin 2006, eq. 14.
    void survey(Change allowed) noexcept;
    /// Mixes the strongest `share` ringing modes.
    void choose(std::int32_t share, std::int64_t grid) noexcept;
    /// Activates all blocks that hold something above τ; the next survey finds the ringing modes.
    void wake(std::int64_t grid) noexcept;

    /// Mixes the modes that increments of these energies [padded size] lift above τ, at most
    /// `allowance` modes in all. During a contact, ringing modes that the budget left out cannot
    /// join, because their forced part would step. Returns whether modes have joined: `joined`.
    bool joinStruck(const float* energies,
                    std::int32_t allowance,
                    bool duringContact,
                    std::int64_t grid) noexcept {
        return join(energies, tauEnergy(), energies, allowance, duringContact, grid);
    }
    /// Mixes all audible modes, like `joinStruck`.
    bool joinAll(std::int32_t allowance, bool duringContact, std::int64_t grid) noexcept {
        return join(bank.poles().audibleWeights(), 0, bank.energies(), allowance, duringContact,
                    grid);
    }
    /// Returns the modes that joined last, valid until the next call on any resonator.
    std::span<const ModeRun> joined() const noexcept { return scratch.joiningRuns; }

    /// Call it before adding to the states at a grid point.
    void bringRestingUpToDate(std::int64_t grid) noexcept;
    /// Call it after adding to the states.
    void listRinging() noexcept;

    /// Fades out newly inaudible modes, still with their old poles: beyond the band the new ones
    /// would alias.
    void fadeInaudible(const ModeGroups& groups, std::int64_t grid) noexcept;
    /// Changes the modes of the bank to `groups`, which have just changed, and keeps their sound.
    /// Each mode takes a fixed share of its group's state along, and modes that join a group add
    /// up, so that no velocity steps. Move the bank's poles next.
    void regroup(const ModeGroups& groups, std::int64_t grid) noexcept;

    void reset() noexcept;

private:
    /// One block of the bank's modes, one bit each. The states of an inactive block stay at grid
    /// point `restsSince` until they are needed.
    struct Block {
        std::uint16_t rings = 0;
        std::uint16_t mixed = 0;
        bool active = false;
        std::int64_t restsSince = 0;
        double restsAtDampingLog = 0;
    };

    float tauEnergy() const noexcept { return static_cast<float>(tauPascals * tauPascals); }
    void rest(Block& block, std::int64_t grid) const noexcept;
    bool bringUpToDate(std::size_t block, std::int64_t grid) noexcept;
    void activate(std::size_t block) noexcept;
    void retireBlocks(std::int64_t grid) noexcept;
    void selectStrongest(std::size_t maximum) noexcept;
    void listMixed() noexcept;
    bool join(const float* energies,
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
    std::vector<Block> states;
    std::vector<std::int32_t> activeBlocks; ///< ascending
    std::vector<std::int32_t> mixed;        ///< ascending
    std::vector<ModeRun> runs;              ///< of `mixed`
    bool mixedIsRinging = true;             ///< the mixed modes are the ringing ones
    ModeDemand demanded;
    double tauPascals = 0; ///< at least the floor below which states become 0
    std::uint64_t changes = 0;
};

} // namespace idiophone
