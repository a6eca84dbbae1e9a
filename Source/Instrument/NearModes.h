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
    double omega = 0; ///< damped [rad/s]
    double decay = 0; ///< [1/s]
    /// Complex velocities for a residue of 1 after the strike of each note.
    std::array<std::array<std::complex<double>, PhraseMeter::notes>, levels> velocities{};
    /// Residues for the strike of each note, left and right.
    std::array<std::array<std::complex<double>, 2>, PhraseMeter::notes> residues{};
};

/// The mean power of the channels for each excitation and note.
template <std::size_t levels>
using RingingPowers = std::array<PhraseMeter::NoteFigures, levels>;

/// Keeps the last modes, with which the next one interferes. The term ∫ v_i v_j dt = Re(A_i A_j* (a
/// + iΔ))/(a² + Δ²)/2, a = α_i + α_j, Δ = ω_i − ω_j, matters for close modes: the pairs of round
/// objects, a bar and its tube, and all modes of soft objects. Add modes in ascending order. Does
/// not allocate.
template <std::size_t levels>
class NearModes {
public:
    /// Adds a mode. If there are too many, calls `take(decay, powers)` with the first one. If the
    /// powers decay with the mode, they carry its energy and half of each interference, so that the
    /// energies of two modes that cancel each other fall together.
    template <class Take>
    void add(const RingingMode<levels>& mode,
             std::size_t firstNote,
             std::size_t endNote,
             const Take& take) noexcept {
        if (count - taken == capacity)
            takeFirst(take);
        auto& added = recent[count % capacity];
        added = {.mode = mode, .powers = {}};
        for (std::size_t note = firstNote; note < endNote; ++note) {
            const auto& [left, right] = mode.residues[note];
            for (std::size_t level = 0; level < levels; ++level)
                added.powers[level][note] = std::norm(mode.velocities[level][note]) *
                                            (std::norm(left) + std::norm(right)) / 4;
        }
        for (std::size_t k = count; k > taken; --k) {
            auto& other = recent[(k - 1) % capacity];
            const double width = mode.decay + other.mode.decay;
            const double distance = mode.omega - other.mode.omega;
            if (distance > farthest * width)
                break;
            const std::complex<double> rate(width, -distance);
            const bool apart = comeApart(mode, other.mode);
            std::array<std::array<std::complex<double>, PhraseMeter::notes>, levels> between{};
            for (std::size_t note = firstNote; note < endNote; ++note) {
                const auto& [left, right] = mode.residues[note];
                const auto residues = product(left, std::conj(other.mode.residues[note][0])) +
                                      product(right, std::conj(other.mode.residues[note][1]));
                for (std::size_t level = 0; level < levels; ++level) {
                    const auto power =
                        product(product(mode.velocities[level][note],
                                        std::conj(other.mode.velocities[level][note])),
                                residues) /
                        2.0;
                    if (apart) {
                        between[level][note] = power;
                        continue;
                    }
                    const double energy = product(power, std::conj(rate)).real() / std::norm(rate);
                    added.powers[level][note] += mode.decay * energy;
                    other.powers[level][note] += other.mode.decay * energy;
                }
            }
            if (apart)
                take(rate / 2.0, between);
        }
        ++count;
    }

    /// Takes all modes that remain.
    template <class Take>
    void takeAll(const Take& take) noexcept {
        while (taken < count)
            takeFirst(take);
    }

private:
    /// Returns whether modes that cancel each other when they are struck do so no longer while they
    /// ring. Their interference then has its own course, which the phrase's blocks hear.
    static bool comeApart(const RingingMode<levels>& one, const RingingMode<levels>& other) {
        constexpr double slow = 60, ratio = 1.3, turn = 0.15; // [1/s]; per width
        const auto [slower, faster] = std::minmax(one.decay, other.decay);
        const double width = one.decay + other.decay;
        const double distance = std::abs(one.omega - other.omega);
        return slower < slow && distance < width &&
               (faster > ratio * slower || distance > turn * width);
    }

    struct Kept {
        RingingMode<levels> mode;
        RingingPowers<levels> powers{};
    };
    static constexpr std::size_t capacity = 32;
    static constexpr double farthest = 10; // resonance widths; beyond lies 1 % of the energy

    template <class Take>
    void takeFirst(const Take& take) noexcept {
        const auto& first = recent[taken++ % capacity];
        take(first.mode.decay, first.powers);
    }

    std::array<Kept, capacity> recent;
    std::size_t count = 0, taken = 0;
};

} // namespace idiophone
