// Continuous contact of a resonator (docs/decisions/0006): output += force ∗ local impulse
// response. The states take in the effect of the force by the next grid point.
#pragma once

#include "Synth/ActiveModes.h"
#include "Synth/ForceResponse.h"
#include "Synth/GroupResidues.h"

#include <cstdint>

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
    /// Applies a valid force in the cell that has begun: adds its sound and moves the states.
    void apply(const ForceCell& force, const CellOutput& cell) noexcept;

    void reset() noexcept;

private:
    static constexpr std::int64_t never = -2;
    /// The response between two points.
    struct Response {
        alignas(64) CellSound sound;
        alignas(64) CellSound tube; ///< the tube's part of `sound`; only set if tubesPulse()
    };

    void blend(const ForcePlace& place,
               const Listening& listening,
               CachedResponses& known,
               ModeResidues& residues,
               Response& response) noexcept;
    const ForceResponse&
    responseAt(const ForcePoint& at, const Listening& listening, CachedResponses& known) noexcept;
    void
    compute(const ForcePoint& at, const Listening& listening, ForceResponse& response) noexcept;
    void sound(std::span<const float, cellSamples> impulses,
               const Response& start,
               const Response& end,
               const CellOutput& cell) const noexcept;

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
