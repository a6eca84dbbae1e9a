// What modes do between their resonances while a continuous force lasts: all of them follow it at
// once, by their stiffness below and by their mass above them.
#pragma once

#include "Instrument/HeldForceSpectrum.h"
#include "Instrument/PhraseMeter.h"

#include <array>
#include <complex>
#include <cstddef>

namespace idiophone {

/// v(ω) = iω Σ r/(λ − ω²) F(ω) at a few frequencies, of all modes that are far from them. Where
/// the force is strong below the lowest mode, as a roll's is, and modes are damped, it is what is
/// heard. As the engine samples force and response, with θ = ω over the sample rate f_s, it is
/// Σ (Re r i sin θ − Im r (1 − cos θ) cot θ_i/2)/(cos θ − cos θ_i)/(2 f_s): the imaginary part of a
/// residue hears the acceleration over ω_i.
/// Does not allocate.
class StiffMotion {
public:
    /// Complex residues left and right, of each note.
    using NoteResidues = std::array<std::array<std::complex<double>, 2>, PhraseMeter::notes>;

    StiffMotion() = default;
    explicit StiffMotion(double sampleRateHz) noexcept;

    /// A mode of that angular frequency [rad/s].
    void add(double omega, const NoteResidues& residues) noexcept;
    /// The K-weighted power of each note, mean of the channels.
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
