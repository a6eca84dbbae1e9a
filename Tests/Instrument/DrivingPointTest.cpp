#include "Instrument/DrivingPoint.h"

#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace idiophone;
using Catch::Approx;

namespace {

constexpr double pi = std::numbers::pi;
const StrikePoint onVertex{.shapeRows = {0}, .weights = {1}, .normal = {0, 0, 1}};

/// An object of one vertex with shapes along z, with the given φ² [1/kg] and frequencies.
ModalObject object(double massKg,
                   const std::vector<double>& frequenciesHz,
                   const std::vector<double>& squaredShapes) {
    ModalObject made;
    made.material.youngsModulusPa = 1e10;
    made.material.densityKgPerM3 = 1000;
    made.vertices = {0, 0, 0};
    made.shapeVertices = {0};
    made.mass = {.massKg = massKg, .inertiaKgM2 = {1, 0, 0, 0, 1, 0, 0, 0, 1}};
    for (std::size_t i = 0; i < frequenciesHz.size(); ++i) {
        made.eigenvalues.push_back(std::pow(2 * pi * frequenciesHz[i], 2));
        made.shapes.insert(made.shapes.end(),
                           {0, 0, static_cast<float>(std::sqrt(squaredShapes[i]))});
    }
    return made;
}

/// A uniform beam, free at both ends and struck in the middle: 1/M and the symmetric modes.
ModalObject bar(double massKg, double fundamentalHz) {
    std::vector<double> frequencies, squares;
    for (int n = 0; n < 12; ++n) {
        const double first = 4.730040745, turn = n == 0 ? first : (2 * n + 1.5) * pi;
        frequencies.push_back(fundamentalHz * std::pow(turn / first, 2));
        squares.push_back((n == 0 ? 1.478 : 2) / massKg); // φ²(L/2) M = 1.4783, 1.9996, ...
    }
    return object(massKg, frequencies, squares);
}

/// A plate of 4 M/Z modes a hertz, so dense that a short contact meets a resistance.
ModalObject plate(double massKg, double resistance) {
    std::vector<double> frequencies, squares;
    for (std::size_t n = 1; n <= DrivingPoint::maximumModes; ++n) {
        frequencies.push_back(static_cast<double>(n) * resistance / (4 * massKg));
        squares.push_back(1 / massKg);
    }
    return object(massKg, frequencies, squares);
}

Striker head(double massKg, double rigidSeconds, double exponent = hertzExponent) {
    ContactLaw law{.stiffness = 1, .exponent = exponent};
    // T ∝ K^(−1/(p+1)).
    law.stiffness = std::pow(contactSeconds(law, massKg, 1) / rigidSeconds, exponent + 1);
    return {.massKg = massKg, .restitution = 1, .law = law};
}

/// The solution of m x'' = −K (x − u)^p until the bodies part; u' is that of the object's free mass
/// and modes.
struct Solved {
    double impulse = 0;
    double seconds = 0; ///< duration of the pulse of Hertz with the same standard deviation
};
Solved solved(const ModalObject& struck, const Striker& striker, double speed) {
    const double step = contactSeconds(striker.law, striker.massKg, speed) / 400;
    std::vector<double> velocity(struck.modeCount()), displacement(struck.modeCount());
    double position = 0, own = speed, rigid = 0, rigidVelocity = 0;
    double sum = 0, moment = 0, second = 0;
    for (int k = 0; k < 20000; ++k) {
        double yielded = rigid;
        for (std::size_t i = 0; i < velocity.size(); ++i)
            yielded += static_cast<double>(struck.shapes[3 * i + 2]) * displacement[i];
        const double compression = position - yielded;
        if (compression < 0)
            break;
        const double force = striker.law.stiffness * std::pow(compression, striker.law.exponent),
                     time = k * step;
        sum += force * step;
        moment += force * time * step;
        second += force * time * time * step;
        own -= force / striker.massKg * step;
        position += own * step;
        rigidVelocity += force / struck.mass.massKg * step;
        rigid += rigidVelocity * step;
        for (std::size_t i = 0; i < velocity.size(); ++i) {
            const double omega = std::sqrt(struck.eigenvalues[i]);
            const double pushed =
                velocity[i] + static_cast<double>(struck.shapes[3 * i + 2]) * force * step;
            velocity[i] =
                pushed * std::cos(omega * step) - omega * displacement[i] * std::sin(omega * step);
            displacement[i] =
                displacement[i] * std::cos(omega * step) + pushed / omega * std::sin(omega * step);
        }
    }
    const double deviation = std::sqrt(second / sum - std::pow(moment / sum, 2));
    constexpr double hertzDeviation =
        0.195; // standard deviation of F ∝ sin^(3/2), in contact times
    return {sum, deviation / hertzDeviation};
}

} // namespace

TEST_CASE("A head rebounds from a rigid wall after its own contact time, with its restitution") {
    for (const double restitution : {0.0, 0.4, 1.0}) {
        auto striker = head(0.03, 1e-3);
        striker.restitution = restitution;
        const auto impact = DrivingPoint().struckBy(striker, 2);
        CHECK(impact.contactSeconds == Approx(contactSeconds(striker.law, 0.03, 2)));
        CHECK(impact.impulseNewtonSeconds == Approx((1 + restitution) * 0.03 * 2));
    }
}

TEST_CASE("On a free mass the contact time and the impulse are those of the reduced mass") {
    const auto striker = head(0.03, 1e-3, 2.2);
    for (const double mass : {0.003, 0.03, 3.0}) {
        const DrivingPoint free(object(mass, {}, {}), onVertex, {});
        const double reduced = 1 / (1 / 0.03 + 1 / mass);
        const auto impact = free.struckBy(striker, 2);
        CHECK(impact.contactSeconds == Approx(contactSeconds(striker.law, reduced, 2)));
        CHECK(impact.impulseNewtonSeconds == Approx(2 * reduced * 2));
    }
}

TEST_CASE("A free body struck off its centre yields by its rotation too") {
    auto struck = object(0.5, {}, {});
    struck.vertices = {0.3f, 0, 0};
    struck.mass.inertiaKgM2 = {0.01, 0, 0, 0, 0.02, 0.003, 0, 0.003, 0.04};
    // r × n = (0, −0.3, 0); (I⁻¹)yy = 0.04/(0.02 · 0.04 − 0.003²).
    const double expected = 1 / 0.5 + 0.09 * 0.04 / (0.02 * 0.04 - 0.003 * 0.003);
    const auto impact = DrivingPoint(struck, onVertex, {}).struckBy(head(3, 1e-3), 2);
    CHECK(impact.impulseNewtonSeconds == Approx(2 * 2 / (1.0 / 3 + expected)).epsilon(1e-6));
}

TEST_CASE("A body in a clamp yields by its modes only") {
    auto struck = object(0.5, {1000}, {2});
    const auto striker = head(0.03, 1e-3);
    const auto free = DrivingPoint(struck, onVertex, {}).struckBy(striker, 2);
    struck.clampedVertices = {0};
    const auto held = DrivingPoint(struck, onVertex, {}).struckBy(striker, 2);
    CHECK(held.impulseNewtonSeconds > free.impulseNewtonSeconds);
    struck.eigenvalues.clear();
    struck.shapes.clear();
    const auto wall = DrivingPoint(struck, onVertex, {}).struckBy(striker, 2);
    CHECK(wall.contactSeconds == Approx(contactSeconds(striker.law, 0.03, 2)));
}

TEST_CASE("A mode far slower than the contact acts as a free mass, and a far faster one is rigid") {
    const auto striker = head(0.03, 1e-3);
    const auto impactOn = [&](double hz) {
        return DrivingPoint(object(0, {hz}, {20}), onVertex, {}).struckBy(striker, 1);
    };
    CHECK(impactOn(1).contactSeconds ==
          Approx(contactSeconds(striker.law, 1 / (1 / 0.03 + 20), 1)).epsilon(1e-3));
    CHECK(impactOn(1).impulseNewtonSeconds == Approx(2 / (1 / 0.03 + 20)).epsilon(1e-3));
    CHECK(impactOn(1e5).contactSeconds == Approx(1e-3).epsilon(1e-3));
    CHECK(impactOn(1e5).impulseNewtonSeconds == Approx(0.06).epsilon(1e-3));
    // The impulse has no step between the two frequencies.
    double last = impactOn(1).impulseNewtonSeconds;
    for (double hz = 1; hz < 1e5; hz *= 1.005) {
        const double impulse = impactOn(hz).impulseNewtonSeconds;
        CHECK(impulse == Approx(last).epsilon(0.01));
        CHECK(impulse >= last * (1 - 1e-3));
        last = impulse;
    }
}

TEST_CASE("A constant resistance takes the momentum of a hard striker, within 1 dB") {
    const double mass = 0.03, resistance = 200;
    const DrivingPoint driven(plate(1, resistance), onVertex, {});
    const auto impact = driven.struckBy(head(mass, 1e-4), 1);
    CHECK(impact.impulseNewtonSeconds == Approx(mass).epsilon(0.1));
    CHECK(impact.contactSeconds == Approx(3 * mass / resistance).epsilon(0.15));
}

TEST_CASE("Heavier heads touch longer, and heavier heads and objects increase the momentum") {
    double longest = 0, mostOfHead = 0, mostOfObject = 0;
    for (const double mass : {0.005, 0.02, 0.08}) {
        const auto small =
            DrivingPoint(bar(0.1, 500), onVertex, {}).struckBy({mass, 0.7, {1e8, 1.5}}, 1);
        CHECK(small.contactSeconds > longest);
        CHECK(small.impulseNewtonSeconds > mostOfHead);
        longest = small.contactSeconds;
        mostOfHead = small.impulseNewtonSeconds;
        const auto large =
            DrivingPoint(bar(4 * mass, 500), onVertex, {}).struckBy({0.02, 0.7, {1e8, 1.5}}, 1);
        CHECK(large.impulseNewtonSeconds > mostOfObject);
        mostOfObject = large.impulseNewtonSeconds;
    }
}

TEST_CASE("Contact time and impulse agree with the equation of motion on bars and plates") {
    struct Case {
        const char* name;
        ModalObject struck;
    };
    const Case cases[] = {{"marimba C3", bar(0.4, 130)},     {"xylophone C5", bar(0.12, 523)},
                          {"xylophone C7", bar(0.05, 2093)}, {"xylophone C8", bar(0.03, 4186)},
                          {"sheet", plate(0.7, 96)},         {"plate", plate(2.1, 860)}};
    for (const auto& [name, struck] : cases)
        for (const double seconds : {2e-3, 1e-3, 3.6e-4})
            for (const double speed : {0.3, 3.0}) {
                const auto striker = head(0.025, seconds);
                const auto impact = DrivingPoint(struck, onVertex, {}).struckBy(striker, speed);
                const auto exact = solved(struck, striker, speed);
                INFO(name << ", " << 1e3 * seconds << " ms, " << speed << " m/s: "
                          << 1e3 * impact.contactSeconds << " ms for " << 1e3 * exact.seconds
                          << ", " << impact.impulseNewtonSeconds << " Ns for " << exact.impulse);
                CHECK(std::abs(std::log2(impact.contactSeconds / exact.seconds)) < 0.4);
                CHECK(std::abs(20 * std::log10(impact.impulseNewtonSeconds / exact.impulse)) < 1);
            }
}

TEST_CASE("A scaled mallet on a scaled object makes the same strike at another scale") {
    const auto struck = bar(0.1, 500);
    const double modulus = 1e8, radius = 0.0125, mass = 0.02;
    for (const double p : {1.5, 2.5})
        for (const double scale : {0.3, 2.0}) {
            const Striker whole{mass, 0.7, contactLaw(radius, modulus, p)};
            const Striker small{mass * std::pow(scale, 3), 0.7,
                                contactLaw(radius * scale, modulus, p)};
            const auto one = DrivingPoint(struck, onVertex, {}).struckBy(whole, 1.5);
            const auto other = DrivingPoint(struck, onVertex, {}, scale).struckBy(small, 1.5);
            CHECK(other.contactSeconds == Approx(scale * one.contactSeconds));
            CHECK(other.impulseNewtonSeconds ==
                  Approx(std::pow(scale, 3) * one.impulseNewtonSeconds));
        }
}

TEST_CASE("Live density, stiffness and thickness act on the struck mass and modes") {
    auto struck = bar(0.1, 500);
    const Striker striker = head(0.02, 5e-4);
    SynthesisSettings dense;
    dense.material = LiveMaterial{.youngsModulusPa = 3e10, .densityKgPerM3 = 2000, .damping = {}};
    auto heavy = struck; // the same object with these constants
    heavy.mass.massKg *= 2;
    for (double& moment : heavy.mass.inertiaKgM2)
        moment *= 2;
    for (double& eigenvalue : heavy.eigenvalues)
        eigenvalue *= 1.5;
    for (float& component : heavy.shapes)
        component /= std::sqrt(2.0f);
    const auto live = DrivingPoint(struck, onVertex, dense).struckBy(striker, 1);
    const auto made = DrivingPoint(heavy, onVertex, {}).struckBy(striker, 1);
    CHECK(live.contactSeconds == Approx(made.contactSeconds).epsilon(1e-5));
    CHECK(live.impulseNewtonSeconds == Approx(made.impulseNewtonSeconds).epsilon(1e-5));

    struck.bending = struck.eigenvalues; // a sheet
    SynthesisSettings thick;
    thick.thicknessRatio = 2;
    // A contact too short for any mode to turn back meets the sum of all mobilities.
    const double mobilityPerKg = (1 + 1.478 + 11 * 2) / 0.1;
    const auto tapOn = [&](const SynthesisSettings& settings) {
        const auto impact = DrivingPoint(struck, onVertex, settings).struckBy(head(1e-3, 1e-9), 1);
        return impact.impulseNewtonSeconds;
    };
    CHECK(tapOn({}) == Approx(2 / (1e3 + mobilityPerKg)).epsilon(1e-5));
    CHECK(tapOn(thick) == Approx(2 / (1e3 + mobilityPerKg / 2)).epsilon(1e-5));
}
