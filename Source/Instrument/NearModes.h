// The energy of modes that lie close together, where it differs from the sum of each mode's energy.
#pragma once

#include "Instrument/PhraseMeter.h"
#include "Synth/ComplexProduct.h"

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>

namespace idiophone {

/// A mode that rings after each of `levels` kinds of excitation.
template <std::size_t levels>
struct RingingMode {
    double omega = 0;                                      ///< damped [rad/s]
    double decay = 0;                                      ///< [1/s]
    std::array<std::complex<double>, levels> velocities{}; ///< for a residue of 1
    /// Residues for the strike of each note, left and right.
    std::array<std::array<std::complex<double>, 2>, PhraseMeter::notes> residues{};
};

/// Keeps the last few modes, with which the next one interferes. The term ∫ v_i v_j dt = Re(A_i
/// A_j* (a + iΔ))/(a² + Δ²)/2, a = α_i + α_j, Δ = ω_i − ω_j, matters for close modes: the pairs of
/// round objects, and all modes of soft objects. Add modes in ascending order. Does not allocate.
template <std::size_t levels>
class NearModes {
public:
    /// Returns the mean power of the channels for each excitation and note. If this power decays
    /// with the mode, it carries the energy of the mode and of its interference with earlier modes.
    std::array<PhraseMeter::NoteFigures, levels>
    add(const RingingMode<levels>& mode, std::size_t firstNote, std::size_t endNote) noexcept {
        std::array<PhraseMeter::NoteFigures, levels> powers{};
        const auto interfere = [&](const RingingMode<levels>& other, std::complex<double> share) {
            std::array<std::complex<double>, levels> both;
            for (std::size_t level = 0; level < levels; ++level)
                both[level] = product(share / 4.0, product(mode.velocities[level],
                                                           std::conj(other.velocities[level])));
            for (std::size_t note = firstNote; note < endNote; ++note) {
                const auto residues =
                    product(mode.residues[note][0], std::conj(other.residues[note][0])) +
                    product(mode.residues[note][1], std::conj(other.residues[note][1]));
                for (std::size_t level = 0; level < levels; ++level)
                    powers[level][note] += product(both[level], residues).real();
            }
        };
        interfere(mode, 1);
        for (std::size_t back = 1; back <= std::min(count, recent.size()); ++back) {
            const auto& other = recent[(count - back) % recent.size()];
            const double width = mode.decay + other.decay;
            const double distance = mode.omega - other.omega;
            if (distance > farthest * width)
                break;
            interfere(other, 4 * mode.decay * std::complex(width, distance) /
                                 (width * width + distance * distance));
        }
        recent[count++ % recent.size()] = mode;
        return powers;
    }

private:
    static constexpr double farthest = 10; // resonance widths; beyond lies 1 % of the energy
    std::array<RingingMode<levels>, 6> recent;
    std::size_t count = 0;
};

} // namespace idiophone
