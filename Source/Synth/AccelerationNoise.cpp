// SPDX-License-Identifier: Apache-2.0
#include "Synth/AccelerationNoise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double airDensityKgPerM3 = 1.2, soundMetresPerSecond = 343;
constexpr std::int64_t rigidModes = 6;

using Matrix = std::array<double, 9>; // symmetric

struct Inverse {
    Matrix matrix;
    double determinant;
};

Inverse inverse(const Matrix& m) noexcept {
    const double a = m[4] * m[8] - m[5] * m[5], b = m[2] * m[5] - m[1] * m[8],
                 c = m[1] * m[5] - m[2] * m[4];
    const double d = m[0] * m[8] - m[2] * m[2], e = m[1] * m[2] - m[0] * m[5],
                 f = m[0] * m[4] - m[1] * m[1];
    const double determinant = m[0] * a + m[1] * b + m[2] * c;
    Matrix result{a, b, c, b, d, e, c, e, f};
    for (double& entry : result)
        entry /= determinant;
    return {result, determinant};
}

double trace(const Matrix& m) noexcept {
    return m[0] + m[4] + m[8];
}

Matrix plusIdentity(Matrix m, double factor, double shift) noexcept {
    for (std::size_t k = 0; k < 9; ++k)
        m[k] = factor * m[k] + (k % 4 == 0 ? shift : 0);
    return m;
}

template <class Vector>
double between(const Vector& left, const Matrix& m, const Vector& right) noexcept {
    double sum = 0;
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            sum += static_cast<double>(left[row]) * m[3 * row + column] *
                   static_cast<double>(right[column]);
    return sum;
}

/// Lamb's α, β, γ as a matrix, for the ellipsoid xᵀ Q⁻¹ x = 1: √(det Q) ∫ (Q + λ)⁻¹/√det(Q + λ) dλ.
/// In ln λ the trapezoidal rule converges faster than any power.
Matrix lambIntegrals(const Matrix& squaredAxes) noexcept {
    constexpr double step = 0.5;
    constexpr int steps = 80; // from 1e-11 to 1e6 times the trace
    const double root = std::sqrt(inverse(squaredAxes).determinant);
    Matrix sum{};
    for (int k = 0; k < steps; ++k) {
        const double lambda = trace(squaredAxes) * std::exp(-26 + step * k);
        const auto [inverted, determinant] = inverse(plusIdentity(squaredAxes, 1, lambda));
        for (std::size_t entry = 0; entry < 9; ++entry)
            sum[entry] += step * lambda * root / std::sqrt(determinant) * inverted[entry];
    }
    return sum;
}

/// Returns the radius of the sphere with the same volumes along the impulse.
double radiusAlong(const RigidRadiator& body, const std::array<float, 3>& impulse) noexcept {
    constexpr Matrix identity{1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double square = between(impulse, identity, impulse);
    const double volume = square > 0 ? between(impulse, body.volumes, impulse) / square : 0;
    return std::cbrt(volume / (2 * pi));
}

} // namespace

RigidRadiator rigidRadiator(const ModalObject& object) noexcept {
    const double massKg = object.mass.massKg;
    if (object.provenance.zeroModes < rigidModes || !(massKg > 0))
        return {};
    const Matrix& inertia = object.mass.inertiaKgM2;
    const double volume = massKg / object.material.densityKgPerM3;
    // The mean of x xᵀ over the mass, bounded to a flatness of 1 : 300.
    const Matrix spread = plusIdentity(inertia, -1 / massKg, trace(inertia) / (2 * massKg));
    const Matrix moments = plusIdentity(spread, 1, 1e-5 * trace(spread));
    const auto ellipsoidVolume = [&](double squares) {
        return 4 * pi / 3 * std::sqrt(squares * squares * squares * inverse(moments).determinant);
    };
    // The mean square along an axis is a²/5 for a full ellipsoid and a²/3 for a hollow one.
    const double squares = 3 + 2 * std::min(volume / ellipsoidVolume(5), 1.0);
    const Matrix lamb = lambIntegrals(plusIdentity(moments, squares, 0));
    // V α/(2 − α), where the trace of α is 2: V (2/(2 − α) − 1).
    const Matrix rest = inverse(plusIdentity(lamb, -1, trace(lamb))).matrix;
    const double moved = ellipsoidVolume(squares);
    RigidRadiator result{.massKg = massKg,
                         .volumes = plusIdentity(rest, trace(lamb) * moved, volume - moved)};
    const bool isSound =
        std::ranges::all_of(result.volumes, [](double entry) { return std::isfinite(entry); });
    return isSound ? result : RigidRadiator{};
}

RigidClick rigidClick(const RigidRadiator& body,
                      const std::array<float, 3>& impulse,
                      double contactSeconds,
                      double sizeRatio,
                      double sampleRateHz,
                      const std::array<std::array<float, 3>, 2>& towards) noexcept {
    // A minimum length keeps the spectrum at low frequencies, so that the click does not alias.
    constexpr double shortestSamples = 4;
    const double radius = sizeRatio * radiusAlong(body, impulse);
    const double seconds =
        std::max(std::hypot(contactSeconds, 3.72 * radius / soundMetresPerSecond),
                 shortestSamples / sampleRateHz);
    RigidClick click{.seconds = seconds};
    for (std::size_t side = 0; side < towards.size(); ++side)
        click.pascalMetres[side] = airDensityKgPerM3 / (4 * pi * soundMetresPerSecond) *
                                   between(towards[side], body.volumes, impulse) / body.massKg * 2 *
                                   pi / (seconds * seconds);
    return click;
}

} // namespace idiophone
