#include "Analysis/ElementSize.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {

double shortestWavelengthMetres(const ElasticLaw& law,
                                double densityKgPerM3,
                                double frequencyHz,
                                double wallThicknessMetres) {
    const double omega = 2 * std::numbers::pi * frequencyHz;
    const double shearSpeed = slowestShearSpeedMetresPerSecond(law, densityKgPerM3);
    const double rod = densityKgPerM3 / minimumYoungsModulusPa(law); // 1/c² of a rod's long waves
    const double shear = 6.0 / 5 / (shearSpeed * shearSpeed);
    const double bending = 4 * 12 * rod / std::pow(omega * wallThicknessMetres, 2);
    const double waveNumber2 =
        omega * omega / 2 * (rod + shear + std::sqrt((rod - shear) * (rod - shear) + bending));
    return 2 * std::numbers::pi / std::sqrt(waveNumber2);
}

double servedFrequencyHz(const ElasticLaw& law,
                         double densityKgPerM3,
                         double maxFrequencyHz,
                         double wallThicknessMetres,
                         double wavelengthMetres) {
    const auto serves = [&](double hz) {
        return shortestWavelengthMetres(law, densityKgPerM3, hz, wallThicknessMetres) >=
               wavelengthMetres;
    };
    if (serves(maxFrequencyHz))
        return maxFrequencyHz;
    double low = 0, high = maxFrequencyHz;
    for (int step = 0; step < 50; ++step) {
        const double middle = (low + high) / 2;
        (serves(middle) ? low : high) = middle;
    }
    return low;
}

double targetEdgeMetres(const ElasticLaw& law,
                        double densityKgPerM3,
                        double maxFrequencyHz,
                        double wallThicknessMetres) {
    const double wave =
        shortestWavelengthMetres(law, densityKgPerM3, maxFrequencyHz, wallThicknessMetres);
    const double inSolid = std::min(wave / elementsPerWavelengthInSolids, wallThicknessMetres / 2);
    const double edge = std::max(inSolid, wave / elementsPerWavelengthInWalls);
    return std::min(edge, flattestElement * wallThicknessMetres);
}

} // namespace idiophone
