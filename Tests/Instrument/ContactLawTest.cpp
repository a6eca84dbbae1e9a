#include "Instrument/ContactLaw.h"
#include "Instrument/MalletStrike.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

using namespace idiophone;
using Catch::Approx;

namespace {

double compliance(const char* material) {
    return surfaceCompliancePerPa(*findMaterial(material), {});
}

/// Contact time on a rigid, heavy object.
double contactMilliseconds(const Mallet& mallet, const char* struck, double speed) {
    return 1000 * contactSeconds(contactLaw(mallet.headRadiusMetres,
                                            contactModulusPa(mallet, compliance(struck)),
                                            mallet.forceExponent),
                                 mallet.massKg, speed);
}

const Mallet& rackMallet(std::string_view name) {
    for (const auto& mallet : malletRack())
        if (mallet.name == name)
            return mallet;
    FAIL("no mallet " << name);
    throw 0;
}

} // namespace

TEST_CASE("The contact times of the rack are those of the Hertz table at 0.3, 1 and 3 m/s") {
    struct Row {
        const char* mallet;
        const char* struck;
        double milliseconds[3];
    };
    const Row table[] = {
        {"Yarn", "Rosewood", {8.48, 5.06, 3.16}},
        {"Soft rubber", "Rosewood", {6.44, 5.06, 4.06}},
        {"Medium rubber", "Rosewood", {2.47, 1.94, 1.56}},
        {"Hard rubber", "Rosewood", {1.27, 0.99, 0.80}},
        {"Wood", "Rosewood", {0.46, 0.36, 0.29}},
        {"Hard plastic", "Rosewood", {0.45, 0.36, 0.29}},
        {"Brass", "Steel", {0.11, 0.09, 0.07}},
    };
    const double speeds[] = {0.3, 1, 3};
    for (const auto& row : table)
        for (int i = 0; i < 3; ++i) {
            INFO(row.mallet << " at " << speeds[i] << " m/s");
            // Tolerates the table's last digit, or 1 % if that is more.
            CHECK(contactMilliseconds(rackMallet(row.mallet), row.struck, speeds[i]) ==
                  Approx(row.milliseconds[i]).margin(0.005).epsilon(0.01));
        }
}

TEST_CASE("At p = 3/2 the contact time is that of Hertz") {
    // T = 2.8683 (m²/(R E*² v))^(1/5), Landau & Lifshitz, Theory of Elasticity, section 9.
    for (const double speed : {0.1, 1.0, 5.0})
        CHECK(contactSeconds(contactLaw(0.0125, 1e9), 0.02, speed) ==
              Approx(2.8683 * std::pow(0.02 * 0.02 / (0.0125 * 1e18 * speed), 0.2)).epsilon(1e-4));
}

TEST_CASE("At p = 1 the contact time is half a period at any speed") {
    const ContactLaw spring{.stiffness = 5000, .exponent = 1};
    for (const double speed : {0.1, 10.0})
        CHECK(contactSeconds(spring, 0.02, speed) ==
              Approx(std::numbers::pi * std::sqrt(0.02 / 5000)));
}

TEST_CASE("The contact time of any exponent agrees with the equation of motion") {
    for (const double exponent : {1.3, 1.5, 2.5, 4.0}) {
        const ContactLaw law{.stiffness = 1e7, .exponent = exponent};
        const double mass = 0.03, speed = 1.5, expected = contactSeconds(law, mass, speed);
        const double step = expected / 40000;
        double compression = 0, velocity = speed, seconds = 0;
        while (compression >= 0) {
            velocity -= step / mass * law.stiffness * std::pow(compression, exponent);
            compression += velocity * step;
            seconds += step;
        }
        CHECK(seconds == Approx(expected).epsilon(1e-3));
    }
}

TEST_CASE("Contact times are proportional to speed^((1 - p)/(1 + p)), exactly") {
    for (const auto& mallet : malletRack()) {
        INFO(mallet.name);
        const double slow = contactMilliseconds(mallet, "Wood", 0.1), p = mallet.forceExponent;
        for (const double speed : {0.3, 1.0, 3.0, 10.0})
            CHECK(std::log(contactMilliseconds(mallet, "Wood", speed) / slow) /
                      std::log(speed / 0.1) ==
                  Approx((1 - p) / (1 + p)).epsilon(1e-9));
    }
}

TEST_CASE("The softer of head and surface decides: brass stays longer on plastic than on steel") {
    const auto& brass = rackMallet("Brass");
    const double onSteel = contactMilliseconds(brass, "Steel", 1);
    const double onPlastic = contactMilliseconds(brass, "Plastic", 1);
    // 1/E* by hand: 1/82.7 + (1 − 0.29²)/200 and 1/82.7 + (1 − 0.35²)/1.4, in 1/GPa.
    CHECK(onPlastic / onSteel ==
          Approx(std::pow((1 / 82.7 + 0.8775 / 1.4) / (1 / 82.7 + 0.9159 / 200), 0.4)));
    const auto& yarn = rackMallet("Yarn");
    CHECK(contactMilliseconds(yarn, "Plastic", 1) ==
          Approx(contactMilliseconds(yarn, "Steel", 1)).epsilon(0.01));
}

TEST_CASE("Each mallet has a name of its own, a source and a contact time of up to 20 ms") {
    std::set<std::string_view> names;
    for (const auto& mallet : malletRack()) {
        INFO(mallet.name);
        CHECK(names.insert(mallet.name).second);
        CHECK_FALSE(mallet.source.empty());
        CHECK(mallet.massKg > 0);
        CHECK(mallet.headRadiusMetres > 0);
        const double milliseconds = contactMilliseconds(mallet, "Steel", 1);
        CHECK(milliseconds > 0.01);
        CHECK(milliseconds < 20);
        // A mallet that becomes the custom one keeps its figures.
        const auto& hardness = parameterInfo(ParameterId::malletHardness);
        CHECK(hardness.clamped(mallet.effectiveModulusPa * 1e-6) ==
              mallet.effectiveModulusPa * 1e-6);
        const auto& mass = parameterInfo(ParameterId::malletMass);
        CHECK(mass.clamped(mallet.massKg * 1e3) == mallet.massKg * 1e3);
        const auto& radius = parameterInfo(ParameterId::malletRadius);
        CHECK(radius.clamped(mallet.headRadiusMetres * 1e3) == mallet.headRadiusMetres * 1e3);
        const auto& exponent = parameterInfo(ParameterId::malletExponent);
        CHECK(exponent.clamped(mallet.forceExponent) == mallet.forceExponent);
    }
}

TEST_CASE("The mallet choice names the rack's mallets in the rack's order") {
    const auto names = choiceNames(ParameterId::mallet);
    const auto rack = malletRack();
    REQUIRE(names.size() == rack.size() + firstRackMallet);
    for (std::size_t i = 0; i < rack.size(); ++i)
        CHECK(names[i + firstRackMallet] == rack[i].name);
}
