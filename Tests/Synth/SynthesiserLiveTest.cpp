// Tests frequency, size and damping that change before and while objects ring.
#include "ModalReference.h"
#include "Support/PoleFit.h"
#include "Synth/ModalPole.h"
#include "Synth/Synthesiser.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRate = 44100;

} // namespace

TEST_CASE("Live material moves frequencies by exactly the root of Y/rho") {
    const double youngs = GENERATE(4.1e9, 2.3e10);
    const double density = GENERATE(700.0, 7850.0);
    const ModalObject object = ringingObject({440});
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    SynthesisSettings settings = exactSettings();
    settings.material = LiveMaterial{youngs, density, {0.5, 0}};
    synthesiser.setSettings(settings);
    const auto output = render(synthesiser, {{0, unitStrike()}}, 1400);
    const double expected = 440 * std::sqrt(youngs / 1e10 / (density / 1000));
    CHECK(std::abs(cents(fitPole(output, sampleRate, expected, 0.5).frequencyHz, expected)) < 1e-3);
}

TEST_CASE("A quarter of the density or half the size equals four times the eigenvalues") {
    ModalObject object = ringingObject({440, 1999});
    ModalObject doubled = object;
    for (double& eigenvalue : doubled.eigenvalues)
        eigenvalue *= 4;
    Synthesiser reference({slotOf(doubled)}, sampleRate);
    reference.setSettings(exactSettings());
    const auto expected = render(reference, {{5, unitStrike()}}, 100);
    const auto check = [&](const SynthesisSettings& settings, double slotSize, float massRatio) {
        Synthesiser synthesiser({slotOf(object, slotSize)}, sampleRate);
        synthesiser.setSettings(settings);
        auto output = render(synthesiser, {{5, unitStrike()}}, 100);
        for (float& sample : output)
            sample *= massRatio;
        CHECK(output == expected);
    };
    SynthesisSettings settings = exactSettings();
    settings.material = LiveMaterial{1e10, 250, {0.5, 0}};
    check(settings, 1, 0.25f);
    check(exactSettings(), 0.5, 0.125f);
    settings = exactSettings();
    settings.sizeRatio = 0.5;
    check(settings, 1, 0.125f);
    settings = exactSettings();
    settings.frequencyRatio = 2;
    check(settings, 1, 1);
}

TEST_CASE("A slot's own material overrides the settings' until it is lifted") {
    const LiveMaterial steel{2e11, 7850, {2, 1e-8}}, wood{1e10, 600, {20, 2e-7}};
    const auto plays = [&](std::size_t slot, const LiveMaterial& atFirst) {
        const ModalObject object = ringingObject({440, 1999});
        Synthesiser own({slotOf(object), slotOf(object)}, sampleRate);
        Synthesiser reference({slotOf(object)}, sampleRate);
        SynthesisSettings settings = exactSettings();
        settings.material = wood;
        own.setSettings(settings);
        own.setMaterial(0, steel);
        own.setMaterial(0, LiveMaterial{2e11, -1, {2, 0}});
        own.setMaterial(2, steel);
        const auto output =
            render(own, {{5, unitStrike(), slot}, {700, unitStrike(1e-3), slot}}, 40, [&](int c) {
                if (c == 20)
                    own.setMaterial(0, std::nullopt);
            });
        settings.material = atFirst;
        reference.setSettings(settings);
        const auto expected =
            render(reference, {{5, unitStrike()}, {700, unitStrike(1e-3)}}, 40, [&](int c) {
                settings.material = c < 20 ? atFirst : wood;
                reference.setSettings(settings);
            });
        return output == expected;
    };
    CHECK(plays(0, steel));
    CHECK(plays(1, wood));
    CHECK_FALSE(plays(0, wood));
}

TEST_CASE("A pole that moves while its mode rings causes no step") {
    const int moveCell = GENERATE(10, 11, 12, 13, 14, 15);
    const ModalObject object = ringingObject({440});
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(exactSettings());
    const auto output = render(synthesiser, {{0, unitStrike()}}, 40, [&](int cell) {
        if (cell == moveCell)
            synthesiser.setFrequencyRatio(0, 1.3);
    });
    // A sinusoid of amplitude 1 changes by at most ω/f_s per sample; a step of 0.3 would show.
    const double most = 2 * std::numbers::pi * 440 * 1.3 / sampleRate;
    double largest = 0;
    for (std::size_t k = 1; k < output.size(); ++k)
        largest = larger(largest, std::abs(double(output[k]) - double(output[k - 1])));
    CHECK(largest < 1.01 * most);
    CHECK(largest > 0.97 * most);
}

TEST_CASE("Crossing critical damping and back keeps velocity and displacement") {
    const double lambda = std::pow(2 * std::numbers::pi * 200, 2);
    const double light = 100;
    const double heavy = 6000;
    ModalObject object = ringingObject({200}, light);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    SynthesisSettings settings = exactSettings();
    synthesiser.setSettings(settings);
    const auto output = render(synthesiser, {{0, unitStrike()}}, 40, [&](int cell) {
        if (cell != 7 && cell != 9)
            return;
        settings.material = LiveMaterial{1e10, 1000, {cell == 7 ? heavy : light, 0}};
        synthesiser.setSettings(settings);
    });
    // Reference: the power series of the equation of motion, sample by sample.
    double v = 1;
    double u = 0;
    double error = 0;
    for (std::size_t k = 0; k < output.size(); ++k) {
        error = larger(error, std::abs(double(output[k]) - v));
        const double damping = k / 64 == 7 || k / 64 == 8 ? heavy : light;
        double dv = v;
        double du = u;
        for (int n = 1; n <= 30; ++n) {
            const double next = (-damping * dv - lambda * du) / sampleRate / n;
            du = dv / sampleRate / n;
            dv = next;
            v += dv;
            u += du;
        }
    }
    CHECK(20 * std::log10(error) < -110);
}

TEST_CASE("Poles and dampers that move during a contact follow the forced equation of motion") {
    const bool damped = GENERATE(false, true);
    const double contactSeconds = 5e-3;
    const double start = 10;
    const ModalObject object = ringingObject({440}, 20);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(exactSettings());
    const auto output =
        render(synthesiser, {{start, unitStrike(contactSeconds)}}, 12, [&](int cell) {
            if (cell != 2)
                return;
            synthesiser.setFrequencyRatio(0, 1.3);
            synthesiser.setDamping(0, damped ? 100 : 0);
        });
    // Runge-Kutta of v' = −(d + δ) v − λ u + f, u' = v − δ u. When the pole moves, the complex
    // velocity amplitude stays the same.
    ModalPole pole{object.eigenvalues[0], 20};
    double delta = 0;
    Motion now;
    double peak = 0;
    double error = 0;
    for (std::size_t k = 0; k < output.size(); ++k) {
        if (k == 128) {
            const ModalPole moved{object.eigenvalues[0] * 1.3 * 1.3, 20};
            now = motionOf(moved, stateOf(pole, now));
            pole = moved;
            delta = damped ? 100 : 0;
        }
        peak = larger(peak, std::abs(now.velocity));
        error = larger(error, std::abs(double(output[k]) - now.velocity));
        const int steps = 32;
        const double h = 1 / (sampleRate * steps);
        const auto slope = [&](const Motion& at, double t) {
            const bool touching = t > 0 && t < contactSeconds;
            const double turn = 2 * std::numbers::pi * t / contactSeconds;
            const double force = touching ? (1 - std::cos(turn)) / contactSeconds : 0;
            return Motion{-(pole.damping + delta) * at.velocity - pole.stiffness * at.displacement +
                              force,
                          at.velocity - delta * at.displacement};
        };
        const auto moved = [&](const Motion& by, double time) {
            return Motion{now.velocity + time * by.velocity,
                          now.displacement + time * by.displacement};
        };
        for (int n = 0; n < steps; ++n) {
            const double t = (double(k) + double(n) / steps - start) / sampleRate;
            const Motion a = slope(now, t);
            const Motion b = slope(moved(a, h / 2), t + h / 2);
            const Motion c = slope(moved(b, h / 2), t + h / 2);
            const Motion d = slope(moved(c, h), t + h);
            now = {now.velocity +
                       h / 6 * (a.velocity + 2 * b.velocity + 2 * c.velocity + d.velocity),
                   now.displacement + h / 6 *
                                          (a.displacement + 2 * b.displacement +
                                           2 * c.displacement + d.displacement)};
        }
    }
    CHECK(20 * std::log10(error / peak) < -100);
}

TEST_CASE("A size whose cube or reciprocal cube overflows is ignored") {
    const double size = GENERATE(1e-110, 1e-50, 1e50, 1e110);
    const ModalObject object = ringingObject({440});
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(exactSettings());
    SynthesisSettings settings = exactSettings();
    settings.sizeRatio = size;
    synthesiser.setSettings(settings);
    const auto output = render(synthesiser, {{0, unitStrike()}}, 10);
    const ReferenceMode mode = referenceMode(object.material, 440, 1);
    CHECK(errorDb(output, [&](double n) { return impulseVelocity(mode, n / sampleRate); }) < -110);
}
