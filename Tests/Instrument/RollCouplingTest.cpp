#include "Instrument/RollCoupling.h"
#include "Support/SyntheticObject.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

Material ownMaterial() {
    auto own = syntheticObject({100}).material;
    own.damping.fluidPerSecond = 40;
    own.damping.viscoelasticSeconds = 1e-6;
    return own;
}

/// α = (γ + ηλ)/2 and f = √(λ − α²)/2π of a mode that sounds at `hz` when it is not damped.
void checkPole(const CoupledMode& mode, double hz, double gamma, double eta) {
    const double lambda = std::pow(2 * std::numbers::pi * hz, 2);
    const double alpha = (gamma + eta * lambda) / 2;
    CHECK(mode.dampingPerSecond == Approx(alpha));
    CHECK(mode.frequencyHz == Approx(std::sqrt(lambda - alpha * alpha) / (2 * std::numbers::pi)));
}

} // namespace

TEST_CASE("A roll is coupled to an object's lowest eight modes where eq. 6 has their poles") {
    const std::vector<double> hz{110, 300, 590, 975, 1450, 2030, 2700, 3450, 4300};
    const LowestModes lowest(syntheticObject(hz), 1);
    const auto coupled = coupledModes(lowest, ownMaterial(), {});
    REQUIRE(coupled.span().size() == 8);
    for (std::size_t k = 0; k < coupled.span().size(); ++k)
        checkPole(coupled.span()[k], hz[k], 40, 1e-6);
}

TEST_CASE("Coupled modes follow size, tuning and live material, damping with the moved frequency") {
    const LowestModes lowest(syntheticObject({110, 300}), 2);
    const auto own = ownMaterial();
    SynthesisSettings settings;
    settings.frequencyRatio = 3;
    settings.sizeRatio = 0.5;
    const auto bent = coupledModes(lowest, own, settings);
    REQUIRE(bent.span().size() == 2);
    checkPole(bent.span()[1], 300.0 / 2 * 3 / 0.5, 40, 1e-6);
    settings.material = LiveMaterial{.youngsModulusPa = 4 * own.youngsModulusPa,
                                     .densityKgPerM3 = own.densityKgPerM3,
                                     .damping = {.fluidPerSecond = 7, .viscoelasticSeconds = 3e-7}};
    const auto other = coupledModes(lowest, own, settings);
    REQUIRE(other.span().size() == 2);
    checkPole(other.span()[0], 110.0 / 2 * 3 / 0.5 * 2, 7, 3e-7);
}

TEST_CASE("Coupled modes follow a live thickness, damping with the moved frequency") {
    auto shell = syntheticObject({110, 300});
    shell.bending = {shell.eigenvalues[0], 0};
    SynthesisSettings settings;
    settings.thicknessRatio = 3;
    const auto coupled = coupledModes(LowestModes(shell, 1), ownMaterial(), settings);
    REQUIRE(coupled.span().size() == 2);
    checkPole(coupled.span()[0], 330, 40, 1e-6);
    checkPole(coupled.span()[1], 300, 40, 1e-6);
}

TEST_CASE("A roll is not coupled to modes that do not sound or do not oscillate") {
    const LowestModes lowest(syntheticObject({15, 25, 300, 9000}), 1);
    auto own = ownMaterial();
    const auto sounding = coupledModes(lowest, own, {});
    REQUIRE(sounding.span().size() == 3);
    checkPole(sounding.span()[0], 25, 40, 1e-6);
    own.damping.fluidPerSecond = 0;
    own.damping.viscoelasticSeconds = 1e-4; // over-damped from 3.2 kHz on
    const auto oscillating = coupledModes(lowest, own, {});
    REQUIRE(oscillating.span().size() == 2);
    checkPole(oscillating.span()[1], 300, 0, 1e-4);
}
