#include "Instrument/StiffMotion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {

StiffMotion::StiffMotion(double sampleRateHz) noexcept : rateHz(sampleRateHz) {
    for (std::size_t k = 0; k < frequencies; ++k) {
        omegas[k] = 2 * std::numbers::pi * lowestHz * std::pow(ratio, static_cast<double>(k));
        cosines[k] = std::cos(omegas[k] / rateHz);
        sines[k] = std::sin(omegas[k] / rateHz);
    }
}

void StiffMotion::add(double omega, const NoteResidues& residues) noexcept {
    constexpr double far = 0.6; // distance over λ beyond which a frequency is off resonance
    const double cosine = std::cos(omega / rateHz), square = omega * omega;
    const double cotangent = 1 / std::tan(omega / rateHz / 2);
    std::array<double, frequencies> compliances;
    for (std::size_t k = 0; k < frequencies; ++k) {
        const double other = omegas[k] * omegas[k];
        const bool isFar = std::abs(square - other) > far * std::max(square, other);
        compliances[k] = isFar ? 1 / (cosines[k] - cosine) : 0;
    }
    for (std::size_t note = 0; note < residues.size(); ++note)
        for (std::size_t channel = 0; channel < 2; ++channel) {
            const std::complex<double> residue = residues[note][channel];
            if (residue != 0.0)
                for (std::size_t k = 0; k < frequencies; ++k)
                    responses[note][channel][k] +=
                        compliances[k] * std::complex(residue.imag() * cotangent * (cosines[k] - 1),
                                                      residue.real() * sines[k]);
        }
}

/// Returns (1/π) ∫ S K |v/F|² dω, with dω = ω ln(ratio).
PhraseMeter::NoteFigures StiffMotion::powers(const HeldForceSpectrum& force) const noexcept {
    PhraseMeter::NoteFigures result{};
    for (std::size_t k = 0; k < frequencies && omegas[k] < std::numbers::pi * rateHz; ++k) {
        const double weight = force.smoothPower(omegas[k]) *
                              kWeightingPower(omegas[k] / (2 * std::numbers::pi)) * omegas[k] *
                              std::log(ratio) / std::numbers::pi / (4 * rateHz * rateHz);
        for (std::size_t note = 0; note < result.size(); ++note)
            for (std::size_t channel = 0; channel < 2; ++channel)
                result[note] += weight * std::norm(responses[note][channel][k]) / 2;
    }
    return result;
}

} // namespace idiophone
