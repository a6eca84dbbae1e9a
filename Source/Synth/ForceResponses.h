// SPDX-License-Identifier: Apache-2.0
// Continuous contact of a resonator (docs/decisions/0006): output += force ∗ local impulse
// response. The states take in the effect of the force by the next grid point.
#pragma once

#include "Synth/ActiveModes.h"
#include "Synth/ForceResponse.h"
#include "Synth/GroupResidues.h"
#include "Synth/HeardForce.h"
#include "Synth/PointModes.h"

#include <cstdint>
#include <span>

namespace idiophone {

/// Memory is reserved by the scratch, which caches the responses; all members are for the audio
/// thread.
class ForceResponses {
public:
    /// The arguments must outlive this object.
    ForceResponses(ModalBank& bank,
                   BankOutput& output,
                   ActiveModes& active,
                   GroupResidues& residues,
                   SynthesisScratch& scratch);

    /// Forgets cached responses after a change of poles, damping, radiation or channels.
    void invalidate() noexcept { ++version; }
    /// Returns whether a force has acted in that cell.
    bool actedIn(std::int64_t cell) const noexcept { return lastCell == cell; }
    /// Begins a force in a cell and returns the maximum share of far sound in it.
    double begin(std::int64_t cell, const Listening& listening) noexcept;
    /// Computes how a valid force is heard in the cell that has begun, whatever its samples.
    void hear(const ForceCell& force, HeardForce& heard) noexcept;
    /// Adds `count` samples of the sound from sample `from` on. Only the force's samples before
    /// their end need be known.
    void add(const HeardForce& heard,
             const ForceCell& force,
             std::size_t from,
             std::size_t count,
             const CellOutput& cell) const noexcept;
    /// Moves the states by the force of the whole cell. Call it before the next cell.
    void move(const ForceCell& force) noexcept {
        HeardForce unheard;
        hear(force, unheard);
        moveAsHeard(force);
    }
    /// Does the same directly after `hear`.
    void moveAsHeard(const ForceCell& force) noexcept;

    /// Finds the modes that yield most at a valid place, unless `modes` are these already. `starts`
    /// are those of the groups (ModeGroups).
    void findModes(const ForcePlace& place,
                   const Listening& listening,
                   std::span<const std::int32_t> starts,
                   PointModes& modes) noexcept;

    void reset() noexcept;

private:
    static constexpr std::int64_t never = -2;

    bool changes(const ForceCell& force) const noexcept {
        return force.start != force.end || startListening != endListening;
    }
    void blend(const ForcePlace& place,
               const Listening& listening,
               const ForceCell& force,
               ModeResidues& residues,
               ForceSound& sound) noexcept;
    const ForceResponse&
    responseAt(const ForcePoint& at, const Listening& listening, const ForceCell& force) noexcept;
    void compute(const ForcePoint& at,
                 const Listening& listening,
                 bool isImpulses,
                 ForceResponse& response) noexcept;

    ModalBank& bank;
    BankOutput& output;
    ActiveModes& active;
    GroupResidues& groupResidues;
    SynthesisScratch& scratch;
    std::uint64_t version = 1;
    std::int64_t lastCell = never;          ///< the last cell with a force
    Listening startListening, endListening; ///< of the last cell with a force
};

} // namespace idiophone
