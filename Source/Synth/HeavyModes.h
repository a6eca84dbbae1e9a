// SPDX-License-Identifier: Apache-2.0
// Modes near or beyond critical damping. They do not fit the rotations of the SIMD loops, which
// pass over them; scalar code then replaces their results. They are few and faint.
#pragma once

#include "Synth/ModeResidues.h"
#include "Synth/ModeRun.h"
#include "Synth/ModeStates.h"
#include "Synth/PoleKernel.h"
#include "Synth/StateIncrements.h"
#include "Synth/UnitContact.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace idiophone {

struct HeavyMode {
    std::size_t mode = 0;
    ModalPole pole;
    Propagator subBlock; ///< motion over 16 samples
    Propagator cell;     ///< motion over 64 samples
    std::array<ModalState, maximumChannels> saved{};

    /// Fills in the states at the start of each sub-block.
    void fillAhead(ModalState state, std::size_t place, SubBlockStates& ahead) const noexcept;
};

/// Memory is reserved by the constructor; every other member is for the audio thread.
class HeavyModes {
public:
    HeavyModes(std::size_t capacity, double sampleRateHz);

    void clear() noexcept { modes.clear(); }
    /// Adds a mode beyond those added before.
    void add(std::size_t mode, const ModalPole& pole) noexcept;
    /// Sets the rotations of heavy modes among `first` to `end` − 1 to 0 and fills in their tables.
    void correct(std::size_t first, std::size_t end, PoleArrays& poles) const noexcept;

    /// Returns the heavy modes among `first` to `end` − 1.
    std::span<const HeavyMode> in(std::size_t first, std::size_t end) const noexcept {
        const auto from = std::ranges::lower_bound(modes, first, {}, &HeavyMode::mode);
        return {from, std::ranges::lower_bound(from, modes.end(), end, {}, &HeavyMode::mode)};
    }

    /// Makes residues real with the same magnitude, because these modes have no phase.
    void makeReal(ModeResidues& residues, std::size_t channels) const noexcept;

    void setForced(const PulseInstant& pulse, UnitContact& unit) const noexcept;
    /// Softens impulses on modes whose velocity falls to less than e^-2 before the next sample. The
    /// sample at the impulse would be far too loud. The states become the means over a time that
    /// grows with the damping d from 0, at d = 2 sample rates, to one sample.
    void setImpulse(UnitContact& unit) const noexcept;
    void start(const UnitContact& unit,
               const ModeResidues& residues,
               const BeforeSample& before,
               std::size_t channels,
               StateIncrements& increments) const noexcept;
    void finish(const UnitContact& unit,
                const ModeResidues& residues,
                const BeforeSample& before,
                const IncrementMove& contact,
                std::size_t channels,
                StateIncrements& increments) const noexcept;

    /// Saves the states of modes `first` to `end` − 1 before a SIMD loop. The functions below
    /// replace the loop's results for these modes.
    void save(const ModeStates& states,
              std::size_t first,
              std::size_t end,
              std::size_t channels) noexcept;
    void advance(std::size_t first,
                 std::size_t end,
                 double seconds,
                 double factor,
                 std::size_t channels,
                 ModeStates& states) const noexcept;
    /// Moves the modes by a cell. Also fills in `ahead` and `energies`, which start at `first`.
    void advanceCell(std::size_t first,
                     std::size_t end,
                     double scale,
                     std::size_t channel,
                     ModeStates& states,
                     float* energies,
                     SubBlockStates& ahead) const noexcept;
    void join(const StateIncrements& increments,
              const IncrementMove& move,
              std::size_t channels,
              ModeStates& states) const noexcept;
    void force(std::span<const float, cellSize> impulses,
               const ModeResidues& startResidues,
               const ModeResidues& endResidues,
               std::size_t channels,
               ModeStates& states) const noexcept;

    /// Sets the energies of modes `first` to `end` − 1.
    void measure(std::size_t first,
                 std::size_t end,
                 const ModeStates& states,
                 std::size_t channels,
                 AlignedVector<float>& energies) const noexcept;

private:
    double sampleSeconds;
    std::vector<HeavyMode> modes; ///< ascending
};

} // namespace idiophone
