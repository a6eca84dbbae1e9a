#include "Object/DampingLaw.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <numbers>

using namespace idiophone;
using Catch::Approx;

TEST_CASE("Without a loss factor the law is Rayleigh damping, to the last bit") {
    const DampingLaw law{.fluidPerSecond = 12.44, .viscoelasticSeconds = 9.16e-8};
    for (double eigenvalue = 1; eigenvalue < 1e11; eigenvalue *= 1.37)
        CHECK(law.perSecond(eigenvalue) == 12.44 + 9.16e-8 * eigenvalue);
}

TEST_CASE("A loss factor is 1/Q and twice the damping ratio at every frequency") {
    const DampingLaw law{.lossFactor = 1e-3}; // brass: a damping ratio of 0.5e-3
    for (double hz = 20; hz < 20000; hz *= 1.5) {
        const double omega = 2 * std::numbers::pi * hz;
        CHECK(omega / law.perSecond(omega * omega) == Approx(1000));
        CHECK(law.perSecond(omega * omega) / 2 == Approx(0.5e-3 * omega));
    }
}

TEST_CASE("The three laws add up") {
    const double omega = 6000;
    const DampingLaw all{.fluidPerSecond = 5, .viscoelasticSeconds = 3e-8, .lossFactor = 2e-4};
    CHECK(all.perSecond(omega * omega) == Approx(5 + 2e-4 * omega + 3e-8 * omega * omega));
}

TEST_CASE("A damped mode sounds below its undamped frequency, and an over-damped one is silent") {
    CHECK(dampedFrequencyHz(25, 3) == 4 / (2 * std::numbers::pi));
    CHECK(dampedFrequencyHz(25, 5) == 0);
    CHECK(dampedFrequencyHz(25, 6) == 0);
}
