#include "Instrument/StrikeSpectrum.h"

#include "Instrument/PhraseMeter.h"

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
    std::complex<double> sum = 0;
    for (const auto& contact : train) {
        const double seconds = contact.strike.durationSeconds;
        const std::complex<double> x(-decay * seconds, omega * seconds);
        const auto pulse = (std::exp(x) - 1.0) * fullTurnSquared / (x * (x * x + fullTurnSquared));
        sum += impulseOf(contact.strike) * pulse *
               std::polar(1.0, -omega * (contact.delaySeconds + seconds));
    }
    return sum;
}

PressedMotion::PressedMotion(const Strike& strike) noexcept
    : seconds(strike.durationSeconds), omega(2 * std::numbers::pi / strike.durationSeconds),
      forceRate(impulseOf(strike) / seconds * omega) {}

std::complex<double> PressedMotion::velocity(double stiffness, double modeOmega) const noexcept {
    constexpr double stiffEnough = 1.7; // λ ≥ (1.3 · 2π/T)²; by comparison with renders
    const double square = omega * omega;
    if (!(stiffness > stiffEnough * square) || !(modeOmega > 0))
        return 0;
    return forceRate / (stiffness - square) * std::complex(1.0, omega / modeOmega);
}

double PressedMotion::energy(double amplitude) const noexcept {
    return amplitude * amplitude / 2 * seconds * kWeightingPower(1 / seconds);
}

} // namespace idiophone
