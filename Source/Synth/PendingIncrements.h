// SPDX-License-Identifier: Apache-2.0
// The state increments of the last strike or the last end of a contact. They sound from their
// sample on, and join the states at the next grid point. Joining them at once would make cells with
// many strikes too slow.
#pragma once

#include "Synth/ActiveModes.h"

#include <cmath>
#include <optional>

namespace idiophone {

/// Returns the first whole sample at or after a time in samples.
inline int firstSampleFrom(double time) noexcept {
    return static_cast<int>(std::ceil(time));
}

/// Memory is reserved by the constructor; every other member is for the audio thread. Contact and
/// residues are those in the scratch.
class PendingIncrements {
public:
    PendingIncrements(ModalBank& bank,
                      BankOutput& output,
                      ActiveModes& active,
                      SynthesisScratch& scratch);

    bool pending() const noexcept { return move.has_value(); }
    const float* energies() const noexcept { return increments.energies.data(); }
    /// Returns the energies that a contact will have left behind, from those at its start; 0 is an
    /// impulse. They are valid until the next call on any resonator.
    const float* energiesAfter(double contactSeconds) const noexcept;

    /// Sets the increments to the contact's states times `sign`, which hold at time `at`, moved to
    /// the next whole sample.
    void start(double sign, double at) noexcept;
    /// Sets the increments of a contact that started in this cell and ended at `end`, moved to the
    /// next whole sample.
    void finish(double contactSeconds, double end) noexcept;
    /// Adds the sound of the increments, which hold at sample `from`, up to `until`.
    void sound(int from, int until, const CellOutput& cell) noexcept;
    /// Adds their sound up to the end of the cell, and keeps the increments until the next grid
    /// point.
    void soundAndKeep(int from, const CellOutput& cell) noexcept;
    /// Adds the increments, which hold at sample `from`, to the states of a sleeping object at
    /// `grid`, the end of the cell. They do not sound.
    void joinAsleep(int from, std::int64_t grid) noexcept;
    /// Adds pending increments to the states, which hold at `grid`, the end of their cell.
    void takeIn(std::int64_t grid) noexcept;
    void reset() noexcept { move.reset(); }

private:
    BeforeSample beforeSample(double at) const noexcept;
    IncrementMove moveBy(double seconds) const noexcept;
    IncrementMove moveToGridFrom(int sample) const noexcept {
        return moveBy((cellSamples - sample) / output.sampleRateHz());
    }

    ModalBank& bank;
    BankOutput& output;
    ActiveModes& active;
    SynthesisScratch& scratch;
    StateIncrements increments;
    std::optional<IncrementMove> move; ///< of pending increments to the next grid point
};

} // namespace idiophone
