#include "Instrument/MalletStrike.h"
#include "Instrument/SettingsOfParameters.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using Catch::Approx;
using enum ParameterId;

namespace {

double rigidMilliseconds(const Striker& mallet, double speed) {
    return 1000 * contactSeconds(mallet.law, mallet.massKg, speed);
}

double contactMilliseconds(double hardnessMPa, double massGrams, double speed) {
    ParameterValues values;
    values.set(malletHardness, hardnessMPa);
    values.set(malletMass, massGrams);
    return rigidMilliseconds(striker({}, values), speed);
}

ParameterValues racked(int choice) {
    ParameterValues values;
    values.set(mallet, choice);
    return values;
}

} // namespace

TEST_CASE("Contact times agree with Hertz for a hard mallet of 20 g on wood") {
    CHECK(contactMilliseconds(1000, 20, 0.3) == Approx(0.46).margin(0.01));
    CHECK(contactMilliseconds(1000, 20, 1) == Approx(0.36).margin(0.01));
    CHECK(contactMilliseconds(1000, 20, 3) == Approx(0.29).margin(0.01));
    CHECK(contactMilliseconds(100, 25, 1) == Approx(0.99).margin(0.01));
}

TEST_CASE("The custom mallet's contact time falls with its radius and ignores the surface") {
    ParameterValues values;
    const double own = rigidMilliseconds(striker({}, values), 1);
    CHECK(rigidMilliseconds(striker({}, values, 1e-9), 1) == own);
    values.set(malletRadius, 25);
    CHECK(rigidMilliseconds(striker({}, values), 1) == Approx(own * std::pow(2, -0.2)));
}

TEST_CASE("The custom mallet has its own exponent") {
    ParameterValues values;
    values.set(malletExponent, 3);
    CHECK(striker({}, values).law.exponent == 3);
}

TEST_CASE("A mallet of the rack has its own figures, and its contact depends on the surface") {
    auto values = racked(5); // wood
    const auto rigid = striker({}, values);
    CHECK(rigid.massKg == Approx(0.016));
    for (const auto figure : malletFigures)
        values.set(figure, parameterInfo(figure).maximum);
    CHECK(rigidMilliseconds(striker({}, values), 1) == rigidMilliseconds(rigid, 1));
    // A surface as compliant as the head halves the modulus.
    CHECK(rigidMilliseconds(striker({}, values, 1 / 8.5e8), 1) ==
          Approx(rigidMilliseconds(rigid, 1) * std::pow(2, 0.4)));
}

TEST_CASE("Hardness shortens the contact of any mallet by its own law") {
    for (int choice = customMallet; choice <= parameterInfo(mallet).maximum; ++choice) {
        auto values = racked(choice);
        const auto own = striker({}, values, 1e-10);
        const double exponent = own.law.exponent;
        for (const double percent : {-100.0, -30.0, 50.0, 100.0}) {
            values.set(hardness, percent);
            const auto harder = striker({}, values, 1e-10);
            CHECK(harder.massKg == own.massKg);
            // T is proportional to k^(−1/(p+1)).
            CHECK(
                rigidMilliseconds(harder, 1) ==
                Approx(rigidMilliseconds(own, 1) * std::pow(60, -percent / 100 / (exponent + 1))));
        }
    }
}

TEST_CASE("A rack mallet made custom strikes as before") {
    const auto& wood = *findMaterial("Rosewood");
    for (int choice = firstRackMallet; choice < firstRackMallet + 7; ++choice) {
        auto values = racked(choice);
        values.set(malletFollow, 60);
        const KeyMallet key{.pitchRatio = 2.5};
        const auto before = striker(key, values, surfaceCompliancePerPa(wood, values));
        const auto custom = withCustom(values, figureChoices[1], &wood);
        CHECK(custom[mallet] == double{customMallet});
        const auto after = striker(key, custom, surfaceCompliancePerPa(wood, custom));
        for (const double speed : {0.3, 3.0})
            CHECK(rigidMilliseconds(after, speed) == Approx(rigidMilliseconds(before, speed)));
        CHECK(after.massKg == Approx(before.massKg));
    }
}

TEST_CASE("If the mallet follows the keys, contact times are proportional to the keys' periods") {
    for (const int choice : {int{customMallet}, int{firstRackMallet}, firstRackMallet + 3}) {
        auto values = racked(choice);
        const double middle = rigidMilliseconds(striker({}, values), 1);
        for (const double share : {0.0, 50.0, 100.0}) {
            values.set(malletFollow, share);
            for (const double ratio : {0.25, 1.0, 4.0})
                CHECK(rigidMilliseconds(striker({.pitchRatio = ratio}, values), 1) ==
                      Approx(middle * std::pow(ratio, -share / 100)));
        }
    }
}

TEST_CASE("The mallet meets the live material if one is chosen, otherwise the object's own") {
    const auto& own = *findMaterial("Plastic");
    const auto& glass = *findMaterial("Glass");
    ParameterValues values;
    CHECK(surfaceCompliancePerPa(own, values) == Approx((1 - 0.35 * 0.35) / 1.4e9));
    values.set(material, *parseParameter(parameterInfo(material), "Glass"));
    CHECK(surfaceCompliancePerPa(own, values) ==
          Approx((1 - glass.poissonRatio * glass.poissonRatio) / glass.youngsModulusPa));
    values.set(material, customMaterial);
    values.set(youngsModulus, 5);
    CHECK(surfaceCompliancePerPa(own, values) == Approx((1 - 0.35 * 0.35) / 5e9));
}

TEST_CASE(
    "On a rigid object the impulse is (1 + e) m v into the surface, and grows with velocity") {
    ParameterValues values;
    values.set(malletMass, 20);
    values.set(malletSpeed, 3);
    values.set(velocityCurve, 1);
    const StrikePoint point{.shapeRows = {}, .weights = {1}, .normal = {0, 0.6f, 0.8f}};
    const SynthesiserSlot rigid{.object = std::make_shared<const ModalObject>()};
    const auto strikeAt = [&](int velocity) {
        return malletStrike(point, velocity, {}, values, rigid);
    };
    const auto hard = strikeAt(127);
    CHECK(hard.impulseNewtonSeconds[0] == 0);
    CHECK(hard.impulseNewtonSeconds[1] == Approx(-1.7 * 0.06 * 0.6));
    CHECK(hard.impulseNewtonSeconds[2] == Approx(-1.7 * 0.06 * 0.8));
    CHECK(hard.point == point);
    double lastImpulse = 0;
    double lastDuration = 1;
    for (int velocity = 1; velocity <= 127; ++velocity) {
        const auto strike = strikeAt(velocity);
        CHECK(-strike.impulseNewtonSeconds[2] > lastImpulse);
        CHECK(strike.durationSeconds < lastDuration);
        lastImpulse = -strike.impulseNewtonSeconds[2];
        lastDuration = strike.durationSeconds;
    }
}

TEST_CASE("A mallet half the size has an eighth of the impulse and half the contact time") {
    for (const int choice : {int{customMallet}, int{firstRackMallet}}) { // Hertz and a wound head
        const auto values = racked(choice);
        const auto whole = DrivingPoint().struckBy(striker({}, values), 2);
        const auto half = DrivingPoint().struckBy(striker({.scale = 0.5}, values), 2);
        CHECK(half.impulseNewtonSeconds == Approx(whole.impulseNewtonSeconds / 8));
        CHECK(half.contactSeconds == Approx(whole.contactSeconds / 2));
    }
}

TEST_CASE("Strike positions reach the ends and stray by no more than the spread") {
    ParameterValues values;
    values.set(strikeSpread, 0);
    CHECK(strikePlace(0.3, values, 7).along == Approx(0.3));
    values.set(strikeAlong, 100);
    values.set(strikeAcross, -100);
    CHECK(strikePlace(0.3, values, 7).along == Approx(1));
    CHECK(strikePlace(0.3, values, 7).across == Approx(-1));
    values.set(strikeAlong, -100);
    CHECK(strikePlace(0.3, values, 7).along == Approx(0));

    values.set(strikeAlong, 0);
    values.set(strikeAcross, 0);
    values.set(strikeSpread, 10);
    double sum = 0;
    double farthest = 0;
    for (std::uint32_t strike = 0; strike < 1000; ++strike) {
        const auto place = strikePlace(0.5, values, strike);
        CHECK(place.along == strikePlace(0.5, values, strike).along);
        sum += place.across;
        farthest = std::max(farthest, std::abs(place.across));
    }
    CHECK(std::abs(sum / 1000) < 0.01);
    CHECK(farthest > 0.09);
    CHECK(farthest <= 0.1);
}
