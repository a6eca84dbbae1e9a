// SPDX-License-Identifier: Apache-2.0
// State increments: what impacts add to the states of modes. Single precision suffices for them,
// though not for states, which keep their phase for hours.
#pragma once

#include "Synth/ModeResidues.h"
#include "Synth/ModeRun.h"

#include <vector>

namespace idiophone {

class ModalBank;
struct UnitContact;

/// A time between two samples. `samples` is the part of a sample up to the later one (below 1).
/// `factor` multiplies states on the way there, besides their free motion.
struct BeforeSample {
    double samples = 0;
    double factor = 1;
};

/// A time of free motion, and the damper's attenuation over it in octaves (≥ 0).
struct IncrementMove {
    double seconds = 0;
    double samples = 0; ///< time in samples
    double damperOctaves = 0;
};

/// The increments of all modes of a bank in its channels. The functions take residues and contacts
/// with room for the bank.
struct StateIncrements {
    StateIncrements(std::size_t modes, std::size_t channels);

    /// Sets the increments to residues times the unit's states, moved to a whole sample.
    void start(const ModalBank& bank,
               const UnitContact& unit,
               const ModeResidues& residues,
               const BeforeSample& before) noexcept;

    /// Sets the increments to those of a whole contact, from start to end. Does not set their
    /// energies.
    void finish(const ModalBank& bank,
                const UnitContact& unit,
                const ModeResidues& residues,
                const BeforeSample& before,
                const IncrementMove& contact) noexcept;

    /// Sets `after` [modes] to the energies that a contact will have left behind, from the
    /// increments at its start. A light damping is ignored.
    void energiesAfter(const ModalBank& bank,
                       double contactSamples,
                       std::vector<float>& after) const noexcept;

    /// Sets the increments, but not their energies, to 0.
    void clear() noexcept;

    /// Adds residues times the unit's states times `factor`, with the immediate sound of the
    /// contact's `force` (0 to 2, in units of 1/T).
    void gather(const ModalBank& bank,
                const UnitContact& unit,
                const ModeResidues& residues,
                double factor,
                double force) noexcept;

    /// Adds the first 16 · `subBlockCount` samples (at most a cell) of the sound over `runs`, and
    /// `parts` of these modes, as `ModalBank::render` does.
    void sound(ModalBank& bank,
               std::span<const ModeRun> runs,
               std::size_t subBlockCount,
               const ChannelOutputs& outputs,
               std::span<const ModePart> parts = {},
               const ChannelOutputs& partOutputs = {}) const noexcept;

    std::array<AlignedVector<float>, maximumChannels> x, y;
    /// |s|² in the louder channel; for heavy modes the square of `amplitudeBound`.
    AlignedVector<float> energies;
};

} // namespace idiophone
