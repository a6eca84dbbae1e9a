#include "Analysis/Tube.h"

#include "Analysis/Air.h"
#include "Analysis/Monopole.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace idiophone {
namespace {

using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
/// A resonance farther from a mode than this does not share it.
constexpr double wholeTone = 1.122;
constexpr double minimumSharedGain = 1e-3;

double waveNumber(double omega) {
    return omega / speedOfSoundMetresPerSecond;
}

/// One mode of the new object.
struct Mode {
    std::size_t source = 0; ///< the bar's mode with this shape and radiation
    double eigenvalue = 0;
    double decay = 0; ///< the part that follows the material
    double extraDecay = 0;
    Complex gain = 1;
    Complex flow = 0; ///< into the tube, per unit modal velocity
};

/// Returns a mode far from the resonances, which drives the tube's impedance at its own frequency.
Mode drivingMode(const ModalObject& bar,
                 std::size_t mode,
                 const ResonantAir& air,
                 double mouthKgPerM2) {
    const double omega = std::sqrt(bar.eigenvalues[mode]);
    const Complex pressure(0, omega * mouthKgPerM2); // per unit modal velocity
    const Complex impedance = air.impedancePaSPerM3(omega / (2 * pi));
    const double extra = bar.damping(mode).extraPerSecond;
    return {.source = mode,
            .eigenvalue = bar.eigenvalues[mode],
            .decay = bar.decayPerSecond(mode) - extra,
            .extraDecay = extra + std::norm(pressure) * (1.0 / impedance).real() / 2,
            .flow = pressure / impedance};
}

/// Returns both modes that replace the bar's mode. The part of a decay that follows the material is
/// found by varying the bar's decay.
std::array<Mode, 2> sharingModes(const ModalObject& bar,
                                 std::size_t mode,
                                 const TubeResonance& resonance,
                                 double mouthKgPerM2) {
    constexpr double step = 1e-3;
    const double omega = std::sqrt(bar.eigenvalues[mode]), decay = bar.decayPerSecond(mode);
    const double ofMaterial = decay - bar.damping(mode).extraPerSecond;
    const auto shared = sharedModes(omega, decay, resonance, mouthKgPerM2);
    const auto varied = sharedModes(omega, decay + step * ofMaterial, resonance, mouthKgPerM2);
    std::array<Mode, 2> result;
    for (std::size_t k = 0; k < 2; ++k) {
        const double whole = -shared[k].pole.real();
        const double following =
            std::clamp((-varied[k].pole.real() - whole) / step, 0.01 * whole, whole);
        result[k] = {.source = mode,
                     .eigenvalue = std::norm(shared[k].pole),
                     .decay = following,
                     .extraDecay = whole - following,
                     .gain = shared[k].gain,
                     .flow = shared[k].flow};
    }
    return result;
}

/// Returns the mode with the strongest coupling to a resonance, if one is near.
std::optional<std::size_t> sharingMode(const ModalObject& bar,
                                       const TubeResonance& resonance,
                                       std::span<const double> mouthKgPerM2) {
    std::optional<std::size_t> found;
    double most = 0;
    for (std::size_t mode = 0; mode < bar.modeCount(); ++mode) {
        const double omega = std::sqrt(bar.eigenvalues[mode]);
        if (omega > wholeTone * resonance.omega || resonance.omega > wholeTone * omega)
            continue;
        const double width = bar.decayPerSecond(mode) + resonance.decayPerSecond;
        const double taken = mouthKgPerM2[mode] * mouthKgPerM2[mode] /
                             (std::pow(omega - resonance.omega, 2) + width * width);
        if (taken > most) {
            most = taken;
            found = mode;
        }
    }
    return found;
}

std::vector<Mode>
modesOver(const ModalObject& bar, const ResonantAir& air, std::span<const double> mouthKgPerM2) {
    std::vector<Mode> modes;
    std::vector<bool> isShared(bar.modeCount());
    for (const TubeResonance& resonance : air.resonances) {
        const auto mode = sharingMode(bar, resonance, mouthKgPerM2);
        if (!mode || isShared[*mode])
            continue;
        const auto pair = sharingModes(bar, *mode, resonance, mouthKgPerM2[*mode]);
        if (std::min(std::abs(pair[0].gain), std::abs(pair[1].gain)) < minimumSharedGain)
            continue;
        isShared[*mode] = true;
        modes.insert(modes.end(), pair.begin(), pair.end());
    }
    for (std::size_t mode = 0; mode < bar.modeCount(); ++mode)
        if (!isShared[mode])
            modes.push_back(drivingMode(bar, mode, air, mouthKgPerM2[mode]));
    std::ranges::sort(modes, {}, &Mode::eigenvalue);
    return modes;
}

} // namespace

double Tube::mouthM2() const {
    return pi * radiusMetres * radiusMetres;
}

double Tube::acousticLengthMetres() const {
    return speedOfSoundMetresPerSecond / (4 * frequencyHz);
}

std::complex<double> Tube::relativeImpedance(double soundHz) const {
    const double wallLossPerMetre = 3e-5 * std::sqrt(soundHz) / radiusMetres;
    const double k = waveNumber(2 * pi * soundHz), ka = k * radiusMetres;
    return 1.0 / std::tanh(Complex(wallLossPerMetre, k) * acousticLengthMetres()) +
           std::min(1.0, ka * ka / 4);
}

TubeResonance Tube::resonance(int n) const {
    const double hz = (2 * n + 1) * frequencyHz;
    const double inertance = airDensityKgPerM3 * acousticLengthMetres() / (2 * mouthM2());
    const double resistance = airImpedancePaSPerM / mouthM2() * relativeImpedance(hz).real();
    return {.omega = 2 * pi * hz,
            .decayPerSecond = resistance / (2 * inertance),
            .inertanceKgPerM4 = inertance};
}

double tubeLengthMetres(const Tube& tube) {
    return tube.acousticLengthMetres() - 0.61 * tube.radiusMetres;
}

std::array<SharedMode, 2> sharedModes(double barOmega,
                                      double barDecayPerSecond,
                                      const TubeResonance& tube,
                                      double mouthKgPerM2) {
    const double inertance = tube.inertanceKgPerM4;
    Eigen::Matrix2d mass, damping, stiffness;
    mass << 1, -mouthKgPerM2, -mouthKgPerM2, inertance;
    damping << 2 * barDecayPerSecond, 0, 0, 2 * inertance * tube.decayPerSecond;
    stiffness << barOmega * barOmega, 0, 0, inertance * tube.omega * tube.omega;
    // Use units of the bar's ω, so that displacements and velocities have similar sizes.
    Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
    companion.topRightCorner<2, 2>().setIdentity();
    companion.bottomLeftCorner<2, 2>() = -mass.inverse() * stiffness / (barOmega * barOmega);
    companion.bottomRightCorner<2, 2>() = -mass.inverse() * damping / barOmega;
    const Eigen::EigenSolver<Eigen::Matrix4d> solver(companion);
    std::array<SharedMode, 2> modes{};
    std::size_t found = 0;
    for (Eigen::Index k = 0; k < 4 && found < 2; ++k) {
        const Complex pole = barOmega * solver.eigenvalues()(k);
        if (!(pole.imag() > 0))
            continue;
        const Eigen::Vector2cd shape = solver.eigenvectors().col(k).head<2>();
        // Eigen's dot() would conjugate.
        const Complex norm =
            (shape.transpose() * (2.0 * pole * mass.cast<Complex>() + damping.cast<Complex>()) *
             shape)(0);
        const Complex alone(1, -pole.real() / pole.imag());
        const Complex answer = 2.0 * pole * shape(0) / (norm * alone);
        modes[found++] = {.pole = pole, .gain = answer * shape(0), .flow = answer * shape(1)};
    }
    const auto order = [](const SharedMode& mode) {
        return std::pair(mode.pole.imag(), -mode.pole.real());
    };
    if (order(modes[1]) < order(modes[0]))
        std::swap(modes[0], modes[1]);
    return modes;
}

void addTube(ModalObject& bar,
             const Tube& tube,
             std::span<const double> mouthKgPerM2,
             const std::array<double, 3>& mouthMetres) {
    std::vector<TubeResonance> resonances;
    for (int n = 0; (2 * n + 1) * tube.frequencyHz < bar.bandHz; ++n)
        resonances.push_back(tube.resonance(n));
    addResonantAir(bar,
                   {.resonances = resonances,
                    .impedancePaSPerM3 =
                        [&](double frequencyHz) {
                            return airImpedancePaSPerM / tube.mouthM2() *
                                   tube.relativeImpedance(frequencyHz);
                        }},
                   mouthKgPerM2, mouthMetres);
}

void addResonantAir(ModalObject& bar,
                    const ResonantAir& air,
                    std::span<const double> mouthKgPerM2,
                    const std::array<double, 3>& mouthMetres) {
    const auto modes = modesOver(bar, air, mouthKgPerM2);
    const ModalObject before = std::exchange(bar, ModalObject(bar));
    const RadiationTable& table = before.radiation;
    const std::size_t ratios = table.frequencyRatios.size(), modesBefore = before.modeCount();
    for (auto* figures : {&bar.eigenvalues, &bar.decaysPerSecond, &bar.extraDecaysPerSecond})
        figures->clear();
    bar.gains.clear();
    bar.shapes.clear();
    bar.radiation.weights.clear();
    for (const Mode& mode : modes) {
        bar.eigenvalues.push_back(mode.eigenvalue);
        bar.decaysPerSecond.push_back(mode.decay);
        bar.extraDecaysPerSecond.push_back(mode.extraDecay);
        bar.gains.push_back(std::complex<float>(mode.gain));
    }
    for (std::size_t row = 0; row < before.shapeVertexCount(); ++row)
        for (const Mode& mode : modes) {
            const auto shape = before.shapesAt(row).subspan(3 * mode.source, 3);
            bar.shapes.insert(bar.shapes.end(), shape.begin(), shape.end());
        }
    for (std::size_t row = 0; row < table.directions.size() * ratios; ++row)
        for (const Mode& mode : modes) {
            const double omega = table.frequencyRatios[row % ratios] * std::sqrt(mode.eigenvalue);
            const Complex ofBar(table.weights[row * modesBefore + mode.source]);
            const Complex ofTube =
                -mode.flow * monopole(omega, table.directions[row / ratios], mouthMetres);
            bar.radiation.weights.push_back(std::complex<float>(mode.gain * ofBar + ofTube));
        }
}

} // namespace idiophone
