#include "Synth/ModalPole.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <cmath>

using namespace idiophone;

namespace {

// Light, near critical from either side, critical, and heavily over-damped; √λ = 1000.
constexpr double natural = 1000;
constexpr double dampingRatios[] = {0.001, 0.5,       0.99, 0.996, 0.9999999,
                                    1.0,   1.0000001, 1.01, 3.0,   300.0};

ModalPole poleOf(double ratio) {
    return {natural * natural, 2 * ratio * natural};
}

} // namespace

TEST_CASE("The propagator solves the equation of motion in every damping regime") {
    const ModalPole pole = poleOf(GENERATE(
        Catch::Generators::from_range(std::begin(dampingRatios), std::end(dampingRatios))));
    const Motion start{1.0, -0.7e-3};
    // An independent solution: the power series of the matrix exponential over small steps.
    double v = start.velocity;
    double u = start.displacement;
    const int steps = 1000;
    const double seconds = 2e-3;
    const double h = seconds / steps;
    for (int n = 0; n < steps; ++n) {
        double dv = v;
        double du = u;
        for (int k = 1; k <= 16; ++k) {
            const double nextV = (-pole.damping * dv - pole.stiffness * du) * h / k;
            du = dv * h / k;
            dv = nextV;
            v += dv;
            u += du;
        }
    }
    const Motion end = motionOf(pole, propagator(pole, seconds) * stateOf(pole, start));
    CHECK(std::abs(end.velocity - v) < 1e-10);
    CHECK(std::abs(end.displacement - u) * natural < 1e-10);
}

TEST_CASE("Motion converted to a state and back is unchanged") {
    const ModalPole pole = poleOf(GENERATE(
        Catch::Generators::from_range(std::begin(dampingRatios), std::end(dampingRatios))));
    const Motion motion{0.3, 0.5e-3};
    const Motion back = motionOf(pole, stateOf(pole, motion));
    CHECK(std::abs(back.velocity - motion.velocity) < 1e-15);
    CHECK(std::abs(back.displacement - motion.displacement) * natural < 1e-12);
}

TEST_CASE(
    "The velocity never exceeds the amplitude bound, which is 2|c||w| if the mode oscillates") {
    const ModalPole pole = poleOf(GENERATE(
        Catch::Generators::from_range(std::begin(dampingRatios), std::end(dampingRatios))));
    for (const Motion start :
         {Motion{1, 0}, Motion{0, 1e-3}, Motion{1, -1e-3}, Motion{-0.2, 1e-3}}) {
        const ModalState state = stateOf(pole, start);
        const double bound = amplitudeBound(pole, state);
        double nearest = 0;
        for (double t = 0; t < 0.05; t += 1e-5) {
            const double velocity = (propagator(pole, t) * state).x;
            const double limit = bound * std::exp(-decayBound(pole) * t);
            CHECK(std::abs(velocity) <= limit * (1 + 1e-9) + 1e-300);
            nearest = std::max(nearest, std::abs(velocity) / limit);
        }
        if (isOscillating(pole) && pole.damping < natural)
            CHECK(nearest > 0.999);
    }
}

TEST_CASE("The stiffness for a damped frequency gives that frequency back") {
    for (const double omega : {130.0, 1600.0, 26000.0})
        for (const DampingLaw& damping : {DampingLaw{}, DampingLaw{60, 2e-7, 0},
                                          DampingLaw{1, 0, 0.3}, DampingLaw{0, 1e-5, 0.05}})
            for (const ModeDamping& mode :
                 {ModeDamping{0.5}, ModeDamping{}, ModeDamping{3, 0.02 * omega}}) {
                const double reference = 0.9 * omega * omega;
                const double stiffness = stiffnessSoundingAt(omega, damping, mode, reference);
                const ModalPole pole =
                    PoleLaw{stiffness / reference, damping}.pole(reference, mode);
                CHECK(std::abs(dampedFrequency(pole) / omega - 1) < 1e-12);
            }
}

TEST_CASE(
    "Beyond a damping ratio of 1/sqrt(2) the stiffness stays at twice the squared frequency") {
    const double omega = 1000;
    double before = omega * omega;
    for (double eta = 0; eta < 3e-3; eta += 1e-6) { // the double root is at 1/ω
        const double stiffness = stiffnessSoundingAt(omega, {.viscoelasticSeconds = eta});
        CHECK(stiffness >= before * (1 - 1e-9));
        CHECK(stiffness <= 2 * omega * omega);
        CHECK(stiffness - before < 0.1 * omega * omega); // a glide makes no jump
        before = stiffness;
    }
    CHECK(before == 2 * omega * omega);
}
