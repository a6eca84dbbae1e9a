#include "Instrument/PhraseMeter.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace idiophone {
namespace {

/// Returns |denominator|² of a second-order filter at x = f/f0.
double denominatorPower(double x, double quality) noexcept {
    const double real = 1 - x * x, imaginary = x / quality;
    return real * real + imaginary * imaginary;
}

/// Returns 1 − e^(−x).
double lostIn(double x) noexcept {
    return -std::expm1(-x);
}
std::complex<double> lostIn(std::complex<double> x) noexcept {
    return 1.0 - std::exp(-x);
}

} // namespace

// Evaluates the analogue filters whose bilinear transforms at 48 kHz give the standard's
// coefficients. With these coefficients the high-pass ends 0.04 dB above 1.
double kWeightingPower(double hz) noexcept {
    constexpr double shelfHz = 1681.974450955533, shelfQuality = 0.7071752369554196;
    constexpr double shelfHigh = 1.584864701130855, shelfMiddle = 1.258720930232562;
    constexpr double highPassHz = 38.13547087602444, highPassQuality = 0.5003270373238773;
    constexpr double highPassPower = 1.01002;
    const double x = hz / shelfHz, y = hz / highPassHz;
    const double real = 1 - shelfHigh * x * x, imaginary = shelfMiddle * x / shelfQuality;
    const double shelf = (real * real + imaginary * imaginary) / denominatorPower(x, shelfQuality);
    return shelf * highPassPower * y * y * y * y / denominatorPower(y, highPassQuality);
}

template <class Number>
void PhraseMeter::addMode(Note note,
                          const std::array<Number, notes>& powers,
                          Number decay,
                          double release) noexcept {
    const Number heldRate = 2.0 * decay, freeRate = heldRate + 2 * release;
    const Number heldLost = lostIn(heldRate * hopSeconds), freeLost = lostIn(freeRate * hopSeconds);
    const bool struck = note == Note::struck;
    // Share lost of energy that arrives at the start of a hop, or throughout the hop.
    const Number addedLost = struck ? heldLost : 1.0 - heldLost / (heldRate * hopSeconds);
    Number held = 0, free = 0;
    for (std::size_t hop = 0; hop < phraseHops; ++hop) {
        const std::size_t index = hop / noteHops;
        const bool begins = hop % noteHops == 0;
        if (begins) {
            free += held;
            held = 0;
        }
        Number added = 0;
        if (index < notes && (begins || !struck))
            added = powers[index] / (struck ? 1.0 : double{noteHops});
        const Number fallen = held * heldLost + added * addedLost, freed = free * freeLost;
        hopEnergies[hop] += std::real(fallen / heldRate + freed / freeRate);
        held += added - fallen;
        free -= freed;
    }
}

template void PhraseMeter::addMode(Note, const NoteFigures&, double decay, double release) noexcept;
template void PhraseMeter::addMode(Note,
                                   const std::array<std::complex<double>, notes>&,
                                   std::complex<double> decay,
                                   double release) noexcept;

void PhraseMeter::addTransients(const NoteFigures& energies) noexcept {
    for (std::size_t note = 0; note < notes; ++note)
        hopEnergies[note * noteHops] += energies[note];
}

void PhraseMeter::addSteady(const NoteFigures& powers) noexcept {
    for (std::size_t hop = 0; hop < notes * noteHops; ++hop)
        hopEnergies[hop] += powers[hop / noteHops] * hopSeconds;
}

double PhraseMeter::integratedLufs() const noexcept {
    std::array<double, phraseHops - blockHops + 1> blocks{};
    for (std::size_t block = 0; block < blocks.size(); ++block)
        for (std::size_t hop = block; hop < block + blockHops; ++hop)
            blocks[block] += hopEnergies[hop] / (blockHops * hopSeconds);
    const auto meanFrom = [&](double gate) {
        double sum = 0;
        int count = 0;
        for (const double power : blocks)
            if (power >= gate) {
                sum += power;
                ++count;
            }
        return count > 0 ? sum / count : 0;
    };
    return -0.691 + 10 * std::log10(std::max(meanFrom(meanFrom(0) / 10), 0.0));
}

} // namespace idiophone
