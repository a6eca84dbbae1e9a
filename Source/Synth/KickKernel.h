// What a strike does to many modes at once, with SIMD chosen at run time: kicks are states that a
// contact adds, in single precision, as a kick is small beside hours of phase. Arrays in, arrays
// out; counts are whole blocks.
#pragma once

#include "Synth/ModalBankKernel.h"

#include <array>
#include <cstddef>
#include <span>

namespace idiophone {

/// As many as there are listening directions: a merged group has a state for each, as its modes are
/// heard in other proportions.
inline constexpr std::size_t mostChannels = 2;

/// One channel: the complex residues of the modes there, and their kicks.
struct KickChannel {
    const float* residuesRe;
    const float* residuesIm;
    float* x;
    float* y;
};
using KickChannels = std::span<const KickChannel>; ///< at most `mostChannels`

/// Oscillating modes −α ± iω, and what a sample does to them: angle in half turns, which is below
/// one within the band, and decay in octaves (≤ 0).
struct KickModes {
    const double* frequency; ///< ω in rad/s
    const float* halfTurnsPerSample;
    const float* octavesPerSample;
};

/// Kicks for residues of 1, [count] each, at a time between two samples; a share of a sample of
/// free motion (0 ≤ `samples` < 1) and `factor` take them to the next one. Modes above the band,
/// which are not heard, arrive with another phase.
struct UnitKicks {
    const float* x;
    const float* y;
    double samples = 0;
    double factor = 1;
};

/// Kicks become residue times unit kick at the start of a contact, and `energies` their |s|² in the
/// louder channel.
void startKicks(const KickModes& modes,
                const UnitKicks& unit,
                std::size_t count,
                KickChannels channels,
                float* energies) noexcept;

/// The forced part of a contact, to be gathered: states for residues of 1, and what of the force
/// the imaginary parts of residues hear at once.
struct ForcedKicks {
    const float* x;
    const float* y;
    const float* perFrequency; ///< Ω/ω
    double force = 0;          ///< f/Ω of a unit impulse
    double factor = 1;
};

/// Kicks grow by `factor` times the residues times these.
void gatherKicks(const ForcedKicks& forced, std::size_t count, KickChannels channels) noexcept;

/// A time of free motion, and how much a damper takes meanwhile (≥ 0).
struct KickMove {
    double seconds = 0;
    double samples = 0; ///< the same
    double damperOctaves = 0;
};

/// Kicks become those of a whole contact: what its end adds and what is left of its start, to
/// single precision of the difference, which is small for contacts much shorter than a period.
void finishKicks(const KickModes& modes,
                 const UnitKicks& end,
                 const KickMove& contact,
                 std::size_t count,
                 KickChannels channels) noexcept;

/// One channel of the states that kicks join.
struct KickedChannel {
    const float* kickX;
    const float* kickY;
    double* x;
    double* y;
};

/// Adds moved kicks to states; `energies` become the states' |s|² in the louder channel.
void joinKicks(const KickModes& modes,
               const KickMove& move,
               std::size_t count,
               std::span<const KickedChannel> channels,
               float* energies) noexcept;

} // namespace idiophone
