#include "Analysis/Cavity.h"

#include "Analysis/Air.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace idiophone {
namespace {

constexpr double pi = std::numbers::pi;

/// The limit of the arithmetic and geometric mean, as in π/2K of an elliptic integral.
double arithmeticGeometricMean(double a, double b) {
    for (int step = 0; step < 8; ++step) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    return a;
}

double stiffnessPaPerM3(const Cavity& cavity) {
    return airImpedancePaSPerM * speedOfSoundMetresPerSecond / cavity.volumeM3;
}

double inertanceKgPerM4(const Cavity& cavity) {
    return airDensityKgPerM3 / cavity.conductivityMetres();
}

double resistancePaSPerM3(const Cavity& cavity, double frequencyHz) {
    const double k = 2 * pi * frequencyHz / speedOfSoundMetresPerSecond;
    const double widthMetres = cavity.mouthM2 / cavity.mouthLengthMetres;
    const double wallLossPerMetre = 3e-5 * std::sqrt(frequencyHz) / widthMetres;
    return airImpedancePaSPerM *
           (k * k / (4 * pi) + 2 * wallLossPerMetre / cavity.conductivityMetres());
}

} // namespace

double Cavity::conductivityMetres() const {
    const double halfLength = mouthLengthMetres / 2, halfWidth = mouthM2 / (pi * halfLength);
    const double ofHole = 2 * arithmeticGeometricMean(halfLength, halfWidth);
    return 1 / (wallMetres / mouthM2 + 1 / ofHole);
}

double Cavity::frequencyHz() const {
    return speedOfSoundMetresPerSecond * std::sqrt(conductivityMetres() / volumeM3) / (2 * pi);
}

TubeResonance Cavity::resonance() const {
    const double hz = frequencyHz(), inertance = inertanceKgPerM4(*this);
    return {.omega = 2 * pi * hz,
            .decayPerSecond = resistancePaSPerM3(*this, hz) / (2 * inertance),
            .inertanceKgPerM4 = inertance};
}

std::complex<double> Cavity::impedancePaSPerM3(double soundHz) const {
    const double omega = 2 * pi * soundHz;
    return {resistancePaSPerM3(*this, soundHz),
            omega * inertanceKgPerM4(*this) - stiffnessPaPerM3(*this) / omega};
}

void addCavity(ModalObject& body,
               const Cavity& cavity,
               std::span<const double> inwardM3,
               const std::array<double, 3>& mouthMetres) {
    std::vector<double> mouthKgPerM2;
    for (std::size_t mode = 0; mode < body.modeCount(); ++mode)
        mouthKgPerM2.push_back(stiffnessPaPerM3(cavity) * inwardM3[mode] / body.eigenvalues[mode]);
    const std::vector resonances{cavity.resonance()};
    addResonantAir(body,
                   {.resonances = resonances,
                    .impedancePaSPerM3 =
                        [&](double frequencyHz) { return cavity.impedancePaSPerM3(frequencyHz); }},
                   mouthKgPerM2, mouthMetres);
}

} // namespace idiophone
