#include "Instrument/RollCoupling.h"
#include "Support/SyntheticObject.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

/// Returns a slot for the object, made of the material `own`.
SynthesiserSlot slotOf(ModalObject object, const Material& own, double sizeRatio = 1) {
    object.material = own;
    return {.object = std::make_shared<const ModalObject>(std::move(object)),
            .sizeRatio = sizeRatio};
}

Material ownMaterial() {
    auto own = syntheticObject({100}).material;
    own.damping.fluidPerSecond = 40;
    own.damping.viscoelasticSeconds = 1e-6;
    return own;
}

/// Checks α = (γ + ηλ)/2 and f = √(λ − α²)/2π of a mode that sounds at `hz` without damping.
void checkPole(const CoupledMode& mode, double hz, double gamma, double eta) {
    const double lambda = std::pow(2 * std::numbers::pi * hz, 2);
    const double alpha = (gamma + eta * lambda) / 2;
    CHECK(mode.dampingPerSecond == Approx(alpha));
    CHECK(mode.frequencyHz == Approx(std::sqrt(lambda - alpha * alpha) / (2 * std::numbers::pi)));
}

} // namespace

TEST_CASE("A roll couples to an object's lowest eight modes, at the poles of eq. 6") {
    const std::vector<double> hz{110, 300, 590, 975, 1450, 2030, 2700, 3450, 4300};
    const auto slot = slotOf(syntheticObject(hz), ownMaterial());
    const auto coupled = coupledModes(LowestModes(*slot.object), slot, {});
    REQUIRE(coupled.span().size() == 8);
    for (std::size_t k = 0; k < coupled.span().size(); ++k)
        checkPole(coupled.span()[k], hz[k], 40, 1e-6);
}

TEST_CASE(
    "Coupled modes follow size, tuning and live material, with damping at the moved frequency") {
    const auto own = ownMaterial();
    const auto slot = slotOf(syntheticObject({110, 300}), own, 2);
    const LowestModes lowest(*slot.object);
    SynthesisSettings settings;
    settings.frequencyRatio = 3;
    settings.sizeRatio = 0.5;
    const auto bent = coupledModes(lowest, slot, settings);
    REQUIRE(bent.span().size() == 2);
    checkPole(bent.span()[1], 300.0 / 2 * 3 / 0.5, 40, 1e-6);
    settings.material = LiveMaterial{.youngsModulusPa = 4 * own.youngsModulusPa,
                                     .densityKgPerM3 = own.densityKgPerM3,
                                     .damping = {.fluidPerSecond = 7, .viscoelasticSeconds = 3e-7}};
    const auto other = coupledModes(lowest, slot, settings);
    REQUIRE(other.span().size() == 2);
    checkPole(other.span()[0], 110.0 / 2 * 3 / 0.5 * 2, 7, 3e-7);
}

TEST_CASE("Coupled modes follow a live thickness, with damping at the moved frequency") {
    auto shell = syntheticObject({110, 300});
    shell.bending = {shell.eigenvalues[0], 0};
    SynthesisSettings settings;
    settings.thicknessRatio = 3;
    const auto slot = slotOf(shell, ownMaterial());
    const auto coupled = coupledModes(LowestModes(*slot.object), slot, settings);
    REQUIRE(coupled.span().size() == 2);
    checkPole(coupled.span()[0], 330, 40, 1e-6);
    checkPole(coupled.span()[1], 300, 40, 1e-6);
}

TEST_CASE("Coupled modes keep a slot's pitch under another material and size") {
    auto slot = slotOf(syntheticObject({110, 300}), ownMaterial());
    slot.pitch = PitchMode{.hz = 220, .eigenvalue = slot.object->eigenvalues[0]};
    SynthesisSettings settings{.sizeRatio = 3, .keepPitch = true};
    settings.material = LiveMaterial{
        .youngsModulusPa = 2e11, .densityKgPerM3 = 7800, .damping = {.fluidPerSecond = 40}};
    const auto coupled = coupledModes(LowestModes(*slot.object), slot, settings);
    REQUIRE(coupled.span().size() == 2);
    CHECK(coupled.span()[0].frequencyHz == Approx(220));
}

TEST_CASE("A roll does not couple to modes that do not sound or do not oscillate") {
    const auto object = syntheticObject({15, 25, 300, 9000});
    const LowestModes lowest(object);
    auto own = ownMaterial();
    const auto sounding = coupledModes(lowest, slotOf(object, own), {});
    REQUIRE(sounding.span().size() == 3);
    checkPole(sounding.span()[0], 25, 40, 1e-6);
    own.damping.fluidPerSecond = 0;
    own.damping.viscoelasticSeconds = 1e-4; // over-damped from 3.2 kHz on
    const auto oscillating = coupledModes(lowest, slotOf(object, own), {});
    REQUIRE(oscillating.span().size() == 2);
    checkPole(oscillating.span()[1], 300, 0, 1e-4);
}
