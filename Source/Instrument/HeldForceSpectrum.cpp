#include "Instrument/HeldForceSpectrum.h"

#include "Instrument/PhraseMeter.h"
#include "Synth/SurfaceProfile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr double fullTurn = 2 * std::numbers::pi;
constexpr double noteSeconds = PhraseMeter::noteSeconds;

/// Returns the energy of (h + gt) e^(−αt) over that of e^(−αt), for noise that lasts as long as a
/// note. Noise that arrives a time t before the note's end counts for t plus the time that the mode
/// rings on.
double
coupledPower(std::complex<double> direct, double growth, double decay, double release) noexcept {
    constexpr int steps = 32;
    const double ringing = std::min(0.5 / (decay + release), 2.0);
    const double length = std::min(noteSeconds, 8 / decay);
    double with = 0, without = 0;
    for (int k = 0; k < steps; ++k) {
        const double seconds = (k + 0.5) / steps * length;
        const double weight = (noteSeconds - seconds + ringing) * std::exp(-2 * decay * seconds);
        with += weight * std::norm(direct + growth * seconds);
        without += weight;
    }
    return with / without;
}

} // namespace

HeldForceSpectrum::HeldForceSpectrum(const Surface& surface,
                                     double speedMetresPerSecond,
                                     const ContactForceSettings& settings,
                                     std::span<const CoupledMode> coupledModes,
                                     double sampleRateHz) noexcept
    : rateHz(sampleRateHz), exponent(surface.spectrumExponent) {
    const double fastest = surface.referenceSpeedMetresPerSecond;
    const double slowest = std::max(surface.slowestSpeedMetresPerSecond, 1e-3 * fastest);
    speedRatio = std::clamp(speedMetresPerSecond, slowest, fastest) / fastest;
    const double harmonicOmega =
        fullTurn * speedRatio * sampleRateHz / SurfaceProfile::periodSamples;
    lowestOmega = harmonicOmega * SurfaceProfile::lowestHarmonic;
    highestOmega = harmonicOmega * SurfaceProfile::periodSamples / 2;
    reson = ResonPole::at(surface.resonFrequencyHz * speedRatio,
                          surface.resonDampingPerSecond * speedRatio, sampleRateHz);
    resonGain = reson.unitGainAtZero();
    if (settings.kind != ContactKind::roll)
        return;
    dry = settings.rollDryMix;
    filtered = 1 - settings.rollDryMix;
    coupled = settings.rollModalCoupling;
    lowPassPart = fullTurn * settings.rollLowPassHz / std::numbers::sqrt2;
    modeCount = std::min(coupledModes.size(), modes.size());
    std::copy_n(coupledModes.begin(), modeCount, modes.begin());
}

double HeldForceSpectrum::scrapePower(double omega) const noexcept {
    if (omega < lowestOmega || omega > highestOmega)
        return 0;
    return std::pow(omega / (fullTurn * 1000 * speedRatio), exponent) * resonGain * resonGain *
           reson.power(std::cos(omega / rateHz)) / speedRatio;
}

/// Returns the response of a roll to a scrape, without the coupled modes.
std::complex<double> HeldForceSpectrum::mix(double omega) const noexcept {
    if (filtered == 0)
        return dry;
    const std::complex<double> rise(lowPassPart, omega);
    const double square = lowPassPart * lowPassPart;
    return dry + filtered * 2 * square / (rise * rise + square);
}

double HeldForceSpectrum::smoothPower(double omega) const noexcept {
    return scrapePower(omega) * std::norm(mix(omega));
}

double HeldForceSpectrum::powerTakenBy(double omega, double decay, double release) const noexcept {
    if (coupled == 0)
        return smoothPower(omega);
    auto mean = mix(omega);
    double spread = 0, ownDamping = 0;
    for (const auto& mode : std::span(modes).first(modeCount)) {
        const double damping = mode.dampingPerSecond;
        const double distance = omega - fullTurn * mode.frequencyHz;
        const std::complex<double> width(damping + decay, distance);
        if (std::abs(distance) < damping + decay) {
            ownDamping = damping;
            continue;
        }
        const auto taken = coupled * damping / width;
        mean += taken;
        spread +=
            coupled * coupled * damping * (damping + decay) / std::norm(width) - std::norm(taken);
    }
    const double power =
        ownDamping > 0 ? coupledPower(mean, coupled * ownDamping, decay, release) : std::norm(mean);
    return scrapePower(omega) * (power + spread);
}

} // namespace idiophone
