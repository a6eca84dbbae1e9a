#include "Analysis/Resonator.h"

#include "Analysis/Air.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
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

void addResonator(ModalObject& object, const Resonator& resonator) {
    const double mouthM2 = std::numbers::pi * resonator.radiusMetres * resonator.radiusMetres;
    const auto shapes = upwardShapesAt(object, resonator.offsetMetres);
    const std::size_t modes = object.modeCount();
    object.extraDecaysPerSecond.resize(modes);
    for (std::size_t mode = 0; mode < modes; ++mode) {
        const double lambda = object.eigenvalues[mode];
        const double frequencyHz = std::sqrt(lambda) / (2 * std::numbers::pi);
        const double push = resonator.drive(frequencyHz) * shapes[mode];
        const double conductance = (1.0 / resonator.relativeImpedance(frequencyHz)).real();
        object.extraDecaysPerSecond[mode] += airDensityKgPerM3 * speedOfSoundMetresPerSecond *
                                             mouthM2 * push * push * conductance / 2;
        // The flow into the tube is that of a bar that moves down: what leaves the mouth, upwards.
        const std::complex<double> flow =
            -mouthM2 * push / resonator.relativeImpedance(frequencyHz);
        for (std::size_t place = 0; place < object.radiation.weights.size() / modes; ++place) {
            const double omega =
                object.radiation
                    .frequencyRatios[place % object.radiation.frequencyRatios.size()] *
                std::sqrt(lambda);
            object.radiation.weights[place * modes + mode] +=
                std::complex<float>(std::complex<double>(0, omega * airDensityKgPerM3) /
                                    (4 * std::numbers::pi) * flow);
        }
    }
}

double tubeLengthMetres(const Resonator& resonator) {
    return speedOfSoundMetresPerSecond / (4 * resonator.frequencyHz) -
           0.61 * resonator.radiusMetres;
}

} // namespace idiophone
