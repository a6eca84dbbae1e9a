#include "Instrument/StrikeSpectrum.h"

#include "Instrument/PhraseMeter.h"
#include "Synth/ComplexProduct.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {

double impulseOf(const Strike& strike) noexcept {
    const auto& impulse = strike.impulseNewtonSeconds;
    return std::hypot(impulse[0], impulse[1], impulse[2]);
}

std::complex<double>
ringingVelocity(const ContactTrain& train, double decay, double omega) noexcept {
    constexpr double fullTurnSquared = 4 * std::numbers::pi * std::numbers::pi;
    constexpr double beforeEnd = 0.275; // of the contact
    std::complex<double> sum = 0;
    for (const auto& contact : train) {
        const double half = contact.strike.durationSeconds / 2;
        const auto turn = std::polar(1.0, -omega * (contact.delaySeconds + half));
        const double impulse = impulseOf(contact.strike);
        if (half == 0) {
            sum += impulse * turn;
            continue;
        }
        const auto halfTurn =
            contact.delaySeconds > 0 ? std::polar(1.0, omega * half) : std::conj(turn);
        const double fall = std::exp(-decay * half), rise = 1 / fall;
        const std::complex<double> swing((fall - rise) * halfTurn.real(),
                                         (fall + rise) * halfTurn.imag());
        const std::complex<double> x(-2 * decay * half, 2 * omega * half);
        const auto inverse = std::conj(product(x, product(x, x) + fullTurnSquared));
        sum += impulse * fullTurnSquared * std::exp((2 * beforeEnd - 1) * decay * half) /
               std::norm(inverse) * product(turn, product(swing, inverse));
    }
    return sum;
}

PressedMotion::PressedMotion(const Strike& strike, double sampleRateHz) noexcept
    // An impulse that is spread over one sample has the energy of a raised cosine of 1.5 samples.
    : seconds(std::max(strike.durationSeconds, 1.5 / sampleRateHz)),
      omega(2 * std::numbers::pi / seconds), forceRate(impulseOf(strike) / seconds * omega) {}

bool PressedMotion::holds(const ModalPole& pole) const noexcept {
    constexpr double heavyDecay = 4; // αT
    return pole.damping / 2 * seconds > heavyDecay;
}

std::complex<double> PressedMotion::velocity(const ModalPole& pole,
                                             std::complex<double> residue) const noexcept {
    constexpr double stiffEnough = 1.7; // λ ≥ (1.3 · 2π/T)²; by comparison with renders
    const double square = omega * omega;
    if (!(pole.stiffness > stiffEnough * square) && !holds(pole))
        return 0;
    const std::complex<double> inverse(pole.stiffness - square, -omega * pole.damping);
    const auto perForce = inverse / std::norm(inverse);
    const auto heard =
        isOscillating(pole)
            ? std::complex(residue.real(), omega / dampedFrequency(pole) * residue.imag())
            : std::copysign(std::abs(residue), residue.real() + residue.imag());
    return forceRate * product(perForce, heard);
}

double PressedMotion::energy(double amplitude) const noexcept {
    return amplitude * amplitude / 2 * seconds * kWeightingPower(1 / seconds);
}

} // namespace idiophone
