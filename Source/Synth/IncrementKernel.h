// Applies strikes to many modes, with SIMD chosen at run time. Increments are state increments that
// a contact adds. Single precision suffices for them, though not for states, which keep their phase
// for hours. Arrays in, arrays out; counts are whole blocks.
#pragma once

#include "Synth/ModalBankKernel.h"

#include <array>
#include <cstddef>
#include <span>

namespace idiophone {

/// Maximum number of channels, one per listening direction. A merged group needs a state for each,
/// as its modes are heard in different proportions.
inline constexpr std::size_t maximumChannels = 2;

/// One channel: the complex residues of the modes and their state increments.
struct IncrementChannel {
    const float* residuesRe;
    const float* residuesIm;
    float* x;
    float* y;
};
using IncrementChannels = std::span<const IncrementChannel>; ///< at most `maximumChannels`

/// Oscillating modes −α ± iω and their motion in one sample: the angle in half turns (below 1
/// within the band) and the decay in octaves (≤ 0).
struct IncrementModes {
    const double* frequency; ///< ω in rad/s
    const float* halfTurnsPerSample;
    const float* octavesPerSample;
};

/// Increments for residues of 1, [count] each, at a time between two samples. Free motion over a
/// part of a sample (0 ≤ `samples` < 1) and `factor` move them to the next sample. Modes above the
/// band, which are not heard, get another phase.
struct UnitIncrements {
    const float* x;
    const float* y;
    double samples = 0;
    double factor = 1;
};

/// Sets the increments at the start of a contact to residue times unit increment, and `energies` to
/// their |s|² in the louder channel.
void startIncrements(const IncrementModes& modes,
                     const UnitIncrements& unit,
                     std::size_t count,
                     IncrementChannels channels,
                     float* energies) noexcept;

/// The forced part of a contact: states for residues of 1, and the part of the force that the
/// imaginary parts of residues hear at once.
struct ForcedIncrements {
    const float* x;
    const float* y;
    const float* perFrequency; ///< Ω/ω
    double force = 0;          ///< force over Ω, for a unit impulse
    double factor = 1;
};

/// Adds `factor` times the residues times the forced states to the increments.
void gatherIncrements(const ForcedIncrements& forced,
                      std::size_t count,
                      IncrementChannels channels) noexcept;

/// A time of free motion, and the damper's attenuation over it in octaves (≥ 0).
struct IncrementMove {
    double seconds = 0;
    double samples = 0; ///< the same time in samples
    double damperOctaves = 0;
};

/// Sets the increments to those of a whole contact: the increment at its end minus the rest of the
/// one at its start. For contacts much shorter than a period this difference is small, and still
/// has the full single precision.
void finishIncrements(const IncrementModes& modes,
                      const UnitIncrements& end,
                      const IncrementMove& contact,
                      std::size_t count,
                      IncrementChannels channels) noexcept;

/// One channel: the states and the increments that are added to them.
struct JoinedChannel {
    const float* incrementX;
    const float* incrementY;
    double* x;
    double* y;
};

/// Moves the increments and adds them to the states; sets `energies` to the states' |s|² in the
/// louder channel.
void joinIncrements(const IncrementModes& modes,
                    const IncrementMove& move,
                    std::size_t count,
                    std::span<const JoinedChannel> channels,
                    float* energies) noexcept;

} // namespace idiophone
