#include "Instrument/DrivingPoint.h"

#include "Instrument/StrikePointMetres.h"
#include "Synth/LiveConditions.h"
#include "Synth/PointShapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr double pi = std::numbers::pi;

/// Sums over modes are split into this many, so that the compiler can use SIMD.
constexpr std::size_t sums = 4;
static_assert(DrivingPoint::maximumModes % sums == 0);

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) noexcept {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector& a, const Vector& b) noexcept {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Returns 1/M + (r × n)ᵀ I⁻¹ (r × n), r from the centre of mass. Returns 0 without a mass or in a
/// clamp, and leaves out the rotation if the inertia is singular.
double rigidMobilityPerKg(const ModalObject& object, const StrikePoint& point) noexcept {
    const auto& mass = object.mass;
    if (!(mass.massKg > 0) || !object.clampedVertices.empty())
        return 0;
    const auto place = strikePointMetres(object, point);
    const Vector normal{point.normal[0], point.normal[1], point.normal[2]};
    const Vector lever{place[0] - mass.centreMetres[0], place[1] - mass.centreMetres[1],
                       place[2] - mass.centreMetres[2]};
    const Vector moment = cross(lever, normal);
    const auto& inertia = mass.inertiaKgM2;
    const Vector x{inertia[0], inertia[1], inertia[2]}, y{inertia[3], inertia[4], inertia[5]},
        z{inertia[6], inertia[7], inertia[8]};
    const double determinant = dot(x, cross(y, z));
    const double scale = inertia[0] + inertia[4] + inertia[8];
    if (!(determinant > 1e-12 * scale * scale * scale))
        return 1 / mass.massKg;
    // I is symmetric, so the rows of its adjugate are the cross products of its rows.
    const Vector turned{dot(cross(y, z), moment), dot(cross(z, x), moment),
                        dot(cross(x, y), moment)};
    return 1 / mass.massKg + dot(moment, turned) / determinant;
}

/// r T, from (π² − c²)/(√2 c) = 3. T of a hard impact on a resistance Z is m (π² − c²)/(√2 c Z).
/// Energy is conserved if T = 3 m/Z: the pulse's energy J² 3/(2 Z T) then equals m v²/2 at J = m v.
const double turnOfContact = (std::sqrt(18 + 4 * pi * pi) - std::sqrt(18.0)) / 2;

/// Returns |S|² of a raised cosine at f T up to its first null, and 0 beyond, where |S|² is below a
/// thousandth.
double pulsePower(double turns) noexcept {
    if (turns >= 2)
        return 0;
    const double away = 1 - turns * turns;
    if (std::abs(away) < 1e-4)
        return 0.25;
    const double x = pi * turns;
    const double amplitude = x > 1e-4 ? std::sin(x) / (x * away) : 1;
    return amplitude * amplitude;
}

} // namespace

DrivingPoint::DrivingPoint(const ModalObject& object,
                           const StrikePoint& point,
                           const SynthesisSettings& settings,
                           double slotSizeRatio,
                           const PitchMode* pitch) noexcept
    : modes(std::min(object.modeCount(), maximumModes)) {
    const auto live = liveConditions(object.material, settings, slotSizeRatio, 1, pitch);
    const double thickness = object.hasLiveThickness() ? settings.thicknessRatio : 1;
    const double perMass = live.gainRatio / thickness;
    rigidPerKg = perMass * rigidMobilityPerKg(object, point);
    std::array<float, maximumModes> along, heard; // equal: the kernel projects twice
    projectShapes(pointShapes(object, point), point.normal, point.normal, modes, along.data(),
                  heard.data());
    for (std::size_t i = 0; i < modes; ++i) {
        squaredShapes[i] = perMass * std::pow(static_cast<double>(along[i]), 2);
        // A bar's mode that couples with a tube appears twice, with gains that sum to about 1.
        if (!object.gains.empty())
            squaredShapes[i] *= static_cast<double>(object.gains[i].real());
        eigenvalues[i] = live.law.eigenvalueRatio * object.eigenvalueAt(i, thickness);
    }
    for (std::size_t i = modes; i % sums != 0; ++i)
        squaredShapes[i] = eigenvalues[i] = 0;
}

DrivingPoint::Yielding DrivingPoint::yieldingIn(double contactSeconds) const noexcept {
    const double perSquare = std::pow(contactSeconds / turnOfContact, 2); // 1/r²
    std::array<double, sums> mobility{rigidPerKg}, compliance{};
    for (std::size_t i = 0; i < modes; i += sums)
        for (std::size_t k = 0; k < sums; ++k) {
            const double ratio = perSquare * eigenvalues[i + k];
            const double share = squaredShapes[i + k] / (1 + ratio * ratio);
            mobility[k] += share;
            compliance[k] += ratio * share;
        }
    const auto total = [](const auto& parts) {
        return (parts[0] + parts[1]) + (parts[2] + parts[3]);
    };
    return {total(mobility), total(compliance) * perSquare};
}

double DrivingPoint::impulseMobilityPerKg(double contactSeconds) const noexcept {
    double sum = rigidPerKg;
    const double firstNull = std::pow(4 * pi / contactSeconds, 2);
    for (std::size_t i = 0; i < modes; ++i)
        if (eigenvalues[i] < firstNull)
            sum += squaredShapes[i] *
                   pulsePower(std::sqrt(eigenvalues[i]) / (2 * pi) * contactSeconds);
    return sum;
}

double DrivingPoint::contactSecondsOf(const Striker& striker,
                                      double speedMetresPerSecond) const noexcept {
    constexpr int steps = 6;
    double seconds = contactSeconds(striker.law, striker.massKg, speedMetresPerSecond);
    // The law's time is proportional to the mass to the power 1/(p + 1).
    const double rigidSeconds = seconds, share = 1 / (striker.law.exponent + 1);
    for (int step = 0; step < steps; ++step) {
        const auto object = yieldingIn(seconds);
        const double reduced = 1 / (1 / striker.massKg + object.mobilityPerKg);
        const double free = rigidSeconds * std::pow(reduced / striker.massKg, share);
        seconds = std::sqrt(free * free + pi * pi * reduced * object.complianceMetresPerNewton);
    }
    return seconds;
}

Collision DrivingPoint::struckBy(const Striker& striker,
                                 double speedMetresPerSecond) const noexcept {
    const double seconds = contactSecondsOf(striker, speedMetresPerSecond);
    const double reduced = 1 / (1 / striker.massKg + impulseMobilityPerKg(seconds));
    return {.contactSeconds = seconds,
            .impulseNewtonSeconds = (1 + striker.restitution) * reduced * speedMetresPerSecond};
}

} // namespace idiophone
