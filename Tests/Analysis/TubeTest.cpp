#include "Analysis/Tube.h"
#include "Support/SyntheticObject.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <vector>

using namespace idiophone;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
constexpr Tube tube{
    .frequencyHz = 200, .radiusMetres = 0.025, .offsetMetres = 0, .gapMetres = 0.01};
constexpr float barWeight = 1e-4f;
constexpr double mouth = 0.05; ///< coupling at the mouth in kg/m² per √kg

/// A bar whose modes all have the same shape and weight.
ModalObject bar(const std::vector<double>& frequenciesHz) {
    auto object = test::syntheticObject(frequenciesHz);
    object.bandHz = 1000;
    object.material.damping = {.fluidPerSecond = 8};
    object.radiation = {
        .directions = {{0, 0, 1}},
        .frequencyRatios = {0.5, 1},
        .weights = std::vector<std::complex<float>>(2 * frequenciesHz.size(), {0, barWeight})};
    return object;
}

ModalObject withTube(ModalObject object, double mouthKgPerM2 = mouth) {
    addTube(object, tube, std::vector<double>(object.modeCount(), mouthKgPerM2), {0, 0, 0});
    return object;
}

/// The response at one time: velocity of the bar and flow into the tube.
struct Answer {
    double velocity = 0, flow = 0;
};

/// Integrates the two equations of motion after a modal impulse of 1 (fourth-order Runge-Kutta).
std::vector<Answer> simulated(double omega,
                              double decay,
                              const TubeResonance& resonance,
                              double mouthKgPerM2,
                              double stepSeconds,
                              int steps) {
    using State = std::array<double, 4>; // q, V, q̇, V̇
    const double m = mouthKgPerM2, inertance = resonance.inertanceKgPerM4;
    const double determinant = inertance - m * m;
    const auto slope = [&](const State& s) -> State {
        const double onBar = -omega * omega * s[0] - 2 * decay * s[2];
        const double onAir = inertance * (-resonance.omega * resonance.omega * s[1] -
                                          2 * resonance.decayPerSecond * s[3]);
        return {s[2], s[3], (inertance * onBar + m * onAir) / determinant,
                (m * onBar + onAir) / determinant};
    };
    const auto moved = [](const State& s, const State& by, double seconds) {
        State result;
        for (std::size_t i = 0; i < 4; ++i)
            result[i] = s[i] + seconds * by[i];
        return result;
    };
    State state{0, 0, inertance / determinant, m / determinant};
    std::vector<Answer> answers;
    for (int n = 0; n < steps; ++n) {
        answers.push_back({state[2], state[3]});
        const State a = slope(state), b = slope(moved(state, a, stepSeconds / 2)),
                    c = slope(moved(state, b, stepSeconds / 2)),
                    d = slope(moved(state, c, stepSeconds));
        for (std::size_t i = 0; i < 4; ++i)
            state[i] += stepSeconds / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    }
    return answers;
}

Answer summed(const std::array<SharedMode, 2>& modes, double seconds) {
    Answer sum;
    for (const auto& mode : modes) {
        const Complex state =
            Complex(1, -mode.pole.real() / mode.pole.imag()) * std::exp(mode.pole * seconds);
        sum.velocity += (mode.gain * state).real();
        sum.flow += (mode.flow * state).real();
    }
    return sum;
}

} // namespace

TEST_CASE("A tube's impedance is lowest at its own frequency and its odd multiples") {
    for (const double odd : {1.0, 3.0, 5.0}) {
        const double there = std::abs(tube.relativeImpedance(odd * tube.frequencyHz));
        INFO("partial " << odd);
        for (const double aside : {-0.2, 0.2})
            CHECK(std::abs(tube.relativeImpedance((odd + aside) * tube.frequencyHz)) > 2 * there);
    }
}

TEST_CASE("A tube's Q combines wall and radiation losses") {
    const double waveNumber = 2 * pi * tube.frequencyHz / 343;
    const double wall = 2 * 3e-5 * std::sqrt(tube.frequencyHz) / tube.radiusMetres / waveNumber;
    const double radiated = std::pow(waveNumber * tube.radiusMetres, 2) / pi;
    const auto resonance = tube.resonance(0);
    CHECK_THAT(resonance.omega / (2 * resonance.decayPerSecond),
               WithinRel(1 / (wall + radiated), 1e-3));
}

TEST_CASE("Near a resonance the air oscillator has the tube's impedance") {
    for (const int n : {0, 1, 2}) {
        const auto resonance = tube.resonance(n);
        for (const double ratio : {0.99, 1.0, 1.01}) {
            const double omega = ratio * resonance.omega;
            const Complex oscillator = resonance.inertanceKgPerM4 *
                                       Complex(2 * resonance.decayPerSecond,
                                               omega - resonance.omega * resonance.omega / omega);
            const Complex whole =
                1.204 * 343 / tube.mouthM2() * tube.relativeImpedance(omega / (2 * pi));
            INFO(n << " at " << ratio);
            CHECK(std::abs(oscillator - whole) < 0.03 * std::abs(whole));
        }
    }
}

TEST_CASE("The two shared modes match a simulation of bar and tube within 0.5 dB over 0.5 s") {
    const double detune = GENERATE(0.94, 0.995, 1.0, 1.01);
    const double coupling = GENERATE(0.01, 0.05, 0.2);
    const auto resonance = tube.resonance(0);
    const double omega = detune * resonance.omega;
    constexpr double step = 1.0 / 96000;
    const auto expected = simulated(omega, 4, resonance, coupling, step, 48000);
    const auto modes = sharedModes(omega, 4, resonance, coupling);
    double worst = 0, worstFlow = 0, peak = 0, peakFlow = 0;
    for (std::size_t n = 0; n < expected.size(); ++n) {
        const auto found = summed(modes, static_cast<double>(n) * step);
        worst = std::max(worst, std::abs(found.velocity - expected[n].velocity));
        worstFlow = std::max(worstFlow, std::abs(found.flow - expected[n].flow));
        peak = std::max(peak, std::abs(expected[n].velocity));
        peakFlow = std::max(peakFlow, std::abs(expected[n].flow));
    }
    CAPTURE(detune, coupling);
    // 1e-4 of the peak is 0.5 dB of a part at -55 dB.
    CHECK(worst < 1e-4 * peak);
    CHECK(worstFlow < 1e-4 * peakFlow);
}

TEST_CASE("With a tuned tube, flow builds up and the bar's mode decays faster than alone") {
    const auto resonance = tube.resonance(0);
    const auto modes = sharedModes(resonance.omega, 2, resonance, mouth);
    const auto flowAround = [&](double seconds) {
        double largest = 0;
        for (double t = seconds - 0.005; t < seconds + 0.005; t += 1e-5)
            largest = std::max(largest, std::abs(summed(modes, t).flow));
        return largest;
    };
    CHECK(flowAround(0.03) > 1.6 * flowAround(0.006));
    for (const auto& mode : modes)
        CHECK(mode.pole.real() < -2);
}

TEST_CASE("Without coupling the bar's mode stays unchanged and the tube is silent") {
    const auto resonance = tube.resonance(0);
    const auto modes = sharedModes(resonance.omega * 0.99, 4, resonance, 1e-9);
    const std::size_t own = std::abs(modes[0].gain) > 0.5 ? 0 : 1;
    CHECK(std::abs(modes[own].gain - 1.0) < 1e-6);
    CHECK_THAT(modes[own].pole.real(), WithinRel(-4, 1e-6));
    CHECK(std::abs(modes[1 - own].gain) < 1e-6);
}

TEST_CASE("A tube shares modes at its odd multiples and leaves the others unchanged") {
    const auto object = withTube(bar({200, 400, 600, 800}));
    REQUIRE(object.modeCount() == 6);
    CHECK(validated(object));
    const auto nearTo = [&](double hz) {
        std::size_t count = 0;
        for (std::size_t mode = 0; mode < object.modeCount(); ++mode)
            count += std::abs(object.dampedFrequencyHz(mode) - hz) < 0.02 * hz ? 1u : 0u;
        return count;
    };
    CHECK(nearTo(200) == 2);
    CHECK(nearTo(400) == 1);
    CHECK(nearTo(600) == 2);
    CHECK(nearTo(800) == 1);
    for (std::size_t mode = 0; mode < 6; ++mode)
        if (std::abs(object.dampedFrequencyHz(mode) - 400) < 1) {
            CHECK(object.gains[mode] == 1.0f);
            CHECK(object.extraDecaysPerSecond[mode] < 0.1);
        }
}

TEST_CASE("The two modes shared by a bar and its tube are each other's partners") {
    const auto object = withTube(bar({200, 400}));
    REQUIRE(object.modeCount() == 3);
    CHECK(sharingPartner(object, 0) == 1);
    CHECK(sharingPartner(object, 1) == 0);
    CHECK_FALSE(sharingPartner(object, 2));
}

TEST_CASE("A tube with hardly any coupling leaves the bar its own mode") {
    const auto object = withTube(bar({200}), 1e-6);
    REQUIRE(object.modeCount() == 1);
    CHECK(object.gains[0] == 1.0f);
}

TEST_CASE("A mode off resonance radiates its losses minus the wall's share") {
    const auto object = withTube(bar({330}));
    const double omega = std::sqrt(object.eigenvalues[0]), hz = omega / (2 * pi);
    const auto tubes =
        Complex(object.radiation.weights[1]) - Complex(0, static_cast<double>(barWeight));
    const double radiated = 4 * pi * std::norm(tubes) / (2 * 1.204 * 343); // in watts at q̇ = 1
    const double throughMouth = std::pow(omega / 343 * tube.radiusMetres, 2) / 4;
    const double share = throughMouth / tube.relativeImpedance(hz).real();
    CHECK(share < 1);
    // The energy at q̇ = 1 is 1/2 J and decays at 2α.
    CHECK_THAT(object.extraDecaysPerSecond[0], WithinRel(radiated / share, 1e-3));
}

TEST_CASE("Only the bar's part of a decay rate follows the material, not the tube's") {
    auto soft = bar({200});
    soft.material.damping.fluidPerSecond = 80;
    const auto hard = withTube(bar({200}), 0.005), softer = withTube(soft, 0.005);
    REQUIRE(hard.modeCount() == 2);
    for (const auto* object : {&hard, &softer})
        for (std::size_t mode = 0; mode < object->modeCount(); ++mode) {
            CHECK(object->decaysPerSecond[mode] > 0);
            CHECK(object->extraDecaysPerSecond[mode] >= 0);
        }
    const std::size_t own = std::abs(hard.gains[0]) > std::abs(hard.gains[1]) ? 0 : 1;
    CHECK_THAT(hard.decaysPerSecond[own], WithinRel(4, 0.1));
}

TEST_CASE("A tube's length is a quarter wave less the end correction") {
    CHECK_THAT(tubeLengthMetres(tube), WithinRel(343.0 / 800 - 0.61 * 0.025, 1e-12));
}
