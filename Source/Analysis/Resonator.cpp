#include "Analysis/Resonator.h"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

namespace idiophone {
namespace {

constexpr double speedOfSoundMetresPerSecond = 343, airDensityKgPerM3 = 1.204;
constexpr int modesOfTube = 16;

/// ka: the mouth's radius in wavelengths / 2π.
double mouthSize(const Resonator& resonator) {
    return 2 * std::numbers::pi * resonator.frequencyHz / speedOfSoundMetresPerSecond *
           resonator.radiusMetres;
}

double response(const Resonator& resonator, double frequencyHz) {
    std::complex<double> sum = 0;
    for (int k = 0; k < modesOfTube; ++k) {
        const double n = 2 * k + 1;
        sum += 1 / n /
               std::complex<double>(1, 2 * resonator.qualityFactor() *
                                           (frequencyHz / (n * resonator.frequencyHz) - 1));
    }
    return std::abs(sum);
}

/// [M] upward, on the middle line of the top at x: linear between its vertices.
std::vector<double> upwardShapesAt(const ModalObject& bar, double xMetres) {
    std::size_t left = 0, right = 0;
    double leftX = -std::numeric_limits<double>::infinity(), rightX = -leftX;
    for (std::size_t row = 0; row < bar.shapeVertexCount(); ++row) {
        const auto* place =
            bar.vertices.data() + 3 * static_cast<std::size_t>(bar.shapeVertices[row]);
        const double x = place[0];
        if (std::abs(place[1]) > 1e-6f)
            continue;
        if (x <= xMetres && x > leftX) {
            leftX = x;
            left = row;
        }
        if (x > xMetres && x < rightX) {
            rightX = x;
            right = row;
        }
    }
    const double share = (xMetres - leftX) / (rightX - leftX);
    std::vector<double> shapes;
    for (std::size_t mode = 0; mode < bar.modeCount(); ++mode)
        shapes.push_back(std::lerp(static_cast<double>(bar.shapesAt(left)[3 * mode + 2]),
                                   static_cast<double>(bar.shapesAt(right)[3 * mode + 2]), share));
    return shapes;
}

} // namespace

double Resonator::qualityFactor() const {
    constexpr double lossesWithin = 1.0 / 40;
    const double ka = mouthSize(*this);
    return 1 / (lossesWithin + ka * ka / std::numbers::pi);
}

double Resonator::amplification() const {
    constexpr double pistonMass = 8 / (3 * std::numbers::pi);
    return pistonMass * mouthSize(*this) * 4 / std::numbers::pi * qualityFactor();
}

void addResonator(ModalObject& object, const Resonator& resonator, double surfaceAreaM2) {
    const double flowArea = std::numbers::pi * resonator.radiusMetres * resonator.radiusMetres *
                            resonator.amplification();
    const auto shapes = upwardShapesAt(object, resonator.offsetMetres);
    auto& table = object.radiation;
    const std::size_t modes = object.modeCount(), ratios = table.frequencyRatios.size();
    object.decaysPerSecond.resize(modes);
    for (std::size_t mode = 0; mode < modes; ++mode) {
        const double lambda = object.eigenvalues[mode], omega = std::sqrt(lambda);
        const double shape = shapes[mode];
        const double flow = flowArea * shape * response(resonator, omega / (2 * std::numbers::pi));
        object.decaysPerSecond[mode] = object.material.damping.perSecond(lambda) / 2 +
                                       airDensityKgPerM3 * lambda * flow * flow /
                                           (8 * std::numbers::pi * speedOfSoundMetresPerSecond);
        for (std::size_t d = 0; d < table.directions.size(); ++d)
            for (std::size_t k = 0; k < ratios; ++k) {
                const double hz = table.frequencyRatios[k] * omega / (2 * std::numbers::pi);
                table.weights[(d * ratios + k) * modes + mode] +=
                    static_cast<float>(flowArea * shape * response(resonator, hz) / surfaceAreaM2);
            }
    }
}

double tubeLengthMetres(const Resonator& resonator) {
    return speedOfSoundMetresPerSecond / (4 * resonator.frequencyHz) -
           0.61 * resonator.radiusMetres;
}

} // namespace idiophone
