// The motion of modes between their resonances under a continuous force. Such modes follow the
// force at once: by their stiffness below their frequency, by their mass above.
#pragma once

#include "Instrument/HeldForceSpectrum.h"
#include "Instrument/PhraseMeter.h"

#include <array>
#include <complex>
#include <cstddef>

namespace idiophone {

/// v(ω) = iω Σ r/(λ − ω²) F(ω) at a few frequencies, of all modes far from them. It dominates if
/// the force is strong below the lowest mode, as a roll's is, and modes are damped.
///
/// The engine samples force and response. With θ = ω over the sample rate f_s the motion is then Σ
/// (Re r i sin θ − Im r (1 − cos θ) cot θ_i/2)/(cos θ − cos θ_i)/(2 f_s). The imaginary part of a
/// residue weights the acceleration over ω_i.
///
/// Does not allocate.
class StiffMotion {
public:
    /// Complex residues of each note, left and right.
    using NoteResidues = std::array<std::array<std::complex<double>, 2>, PhraseMeter::notes>;

    StiffMotion() = default;
    explicit StiffMotion(double sampleRateHz) noexcept;

    /// Adds a mode of this angular frequency [rad/s].
    void add(double omega, const NoteResidues& residues) noexcept;
    /// Returns the K-weighted power of each note, mean of the channels.
    PhraseMeter::NoteFigures powers(const HeldForceSpectrum& force) const noexcept;

private:
    static constexpr std::size_t frequencies = 26;
    static constexpr double lowestHz = 25, ratio = 1.3; // up to 18 kHz

    double rateHz = 1;
    std::array<double, frequencies> omegas{}, cosines{}, sines{};
    std::array<std::array<std::array<std::complex<double>, frequencies>, 2>, PhraseMeter::notes>
        responses{};
};

} // namespace idiophone
