#include "Analysis/Resonator.h"

#include "Analysis/Air.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace idiophone {
namespace {

/// k in rad/m.
double waveNumber(double frequencyHz) {
    return 2 * std::numbers::pi * frequencyHz / speedOfSoundMetresPerSecond;
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

std::complex<double> Resonator::relativeImpedance(double soundHz) const {
    const double wallLossPerMetre = 3e-5 * std::sqrt(soundHz) / radiusMetres;
    const double acousticLengthMetres = speedOfSoundMetresPerSecond / (4 * frequencyHz);
    const double k = waveNumber(soundHz), ka = k * radiusMetres;
    return 1.0 / std::tanh(std::complex(wallLossPerMetre, k) * acousticLengthMetres) +
           std::min(1.0, ka * ka / 4);
}

double Resonator::drive(double soundHz) const {
    const double detourMetres = std::hypot(radiusMetres, gapMetres) - gapMetres;
    return 2 * std::abs(std::sin(waveNumber(soundHz) * detourMetres / 2));
}

double Resonator::flowGain(double soundHz) const {
    return drive(soundHz) / std::abs(relativeImpedance(soundHz));
}

void addResonator(ModalObject& object, const Resonator& resonator, double surfaceAreaM2) {
    const double mouthM2 = std::numbers::pi * resonator.radiusMetres * resonator.radiusMetres;
    const auto shapes = upwardShapesAt(object, resonator.offsetMetres);
    const std::size_t modes = object.modeCount();
    std::vector<double> decays;
    for (std::size_t mode = 0; mode < modes; ++mode) {
        const double frequencyHz = std::sqrt(object.eigenvalues[mode]) / (2 * std::numbers::pi);
        const double push = resonator.drive(frequencyHz) * shapes[mode];
        const double conductance = (1.0 / resonator.relativeImpedance(frequencyHz)).real();
        decays.push_back(object.decayPerSecond(mode) + airDensityKgPerM3 *
                                                           speedOfSoundMetresPerSecond * mouthM2 *
                                                           push * push * conductance / 2);
        const double tube =
            -mouthM2 * resonator.flowGain(frequencyHz) * shapes[mode] / surfaceAreaM2;
        for (std::size_t place = mode; place < object.radiation.weights.size(); place += modes) {
            float& weight = object.radiation.weights[place];
            const double bar = weight;
            weight = static_cast<float>(
                std::copysign(std::hypot(bar, tube), std::abs(tube) > std::abs(bar) ? tube : bar));
        }
    }
    object.decaysPerSecond = std::move(decays);
}

double tubeLengthMetres(const Resonator& resonator) {
    return speedOfSoundMetresPerSecond / (4 * resonator.frequencyHz) -
           0.61 * resonator.radiusMetres;
}

} // namespace idiophone
