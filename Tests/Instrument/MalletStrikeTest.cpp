#include "Instrument/MalletStrike.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using Catch::Approx;
using enum ParameterId;

namespace {

double contactMilliseconds(double hardnessMPa, double massGrams, double speed) {
    ParameterValues values;
    values.set(malletHardness, hardnessMPa);
    values.set(malletMass, massGrams);
    values.set(malletSpeed, speed);
    return malletStrike({}, 127, 1, values).durationSeconds * 1000;
}

} // namespace

TEST_CASE("Contact times agree with Hertz for a hard mallet of 20 g on wood") {
    CHECK(contactMilliseconds(1000, 20, 0.3) == Approx(0.46).margin(0.01));
    CHECK(contactMilliseconds(1000, 20, 1) == Approx(0.36).margin(0.01));
    CHECK(contactMilliseconds(1000, 20, 3) == Approx(0.29).margin(0.01));
    CHECK(contactMilliseconds(100, 25, 1) == Approx(0.99).margin(0.01));
}

TEST_CASE("The custom mallet's contact time falls with its radius and ignores what is struck") {
    ParameterValues values;
    const double own = malletStrike({}, 100, 1, values).durationSeconds;
    CHECK(malletStrike({}, 100, 1, values, 1e-9).durationSeconds == own);
    CHECK(own ==
          2.87 * std::pow(0.02 * 0.02 / (0.0125 * 1e9 * 1e9 * 3 * std::pow(100 / 127.0, 1.5)),
                          0.2)); // to the last bit, as before there was a rack
    values.set(malletRadius, 25);
    CHECK(malletStrike({}, 100, 1, values).durationSeconds == Approx(own * std::pow(2, -0.2)));
}

TEST_CASE("A mallet of the rack brings its own mass, radius and modulus, and meets the surface") {
    ParameterValues values;
    values.set(mallet, 5); // wood
    values.set(velocityCurve, 1);
    values.set(malletSpeed, 3);
    const StrikePoint point{.shapeRows = {0, 0, 0}, .weights = {1, 0, 0}, .normal = {0, 0, 1}};
    const auto rigid = malletStrike(point, 127, 1, values);
    CHECK(rigid.impulseNewtonSeconds[2] == Approx(-0.016 * 3));
    values.set(malletHardness, 5);
    values.set(malletMass, 300);
    values.set(malletRadius, 50);
    CHECK(malletStrike(point, 127, 1, values).durationSeconds == rigid.durationSeconds);
    // A surface as compliant as the head: half the modulus.
    CHECK(malletStrike(point, 127, 1, values, 1 / 8.5e8).durationSeconds ==
          Approx(rigid.durationSeconds * std::pow(2, 0.4)));
    values.set(mallet, parameterInfo(mallet).maximum); // kept free: as custom
    CHECK(malletStrike(point, 127, 1, values).impulseNewtonSeconds[2] == Approx(-0.9));
}

TEST_CASE("The live material is what the mallet meets where one is chosen, else the object's own") {
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

TEST_CASE("The impulse is mass times speed, into the surface, and grows with velocity") {
    ParameterValues values;
    values.set(malletMass, 20);
    values.set(malletSpeed, 3);
    values.set(velocityCurve, 1);
    const StrikePoint point{
        .shapeRows = {5, 0, 0}, .weights = {1, 0, 0}, .normal = {0, 0.6f, 0.8f}};
    const auto hard = malletStrike(point, 127, 1, values);
    CHECK(hard.impulseNewtonSeconds[0] == 0);
    CHECK(hard.impulseNewtonSeconds[1] == Approx(-0.06 * 0.6));
    CHECK(hard.impulseNewtonSeconds[2] == Approx(-0.06 * 0.8));
    CHECK(hard.point.shapeRows[0] == 5);
    double lastImpulse = 0;
    double lastDuration = 1;
    for (int velocity = 1; velocity <= 127; ++velocity) {
        const auto strike = malletStrike(point, velocity, 1, values);
        CHECK(-strike.impulseNewtonSeconds[2] > lastImpulse);
        CHECK(strike.durationSeconds < lastDuration);
        lastImpulse = -strike.impulseNewtonSeconds[2];
        lastDuration = strike.durationSeconds;
    }
}

TEST_CASE("A mallet half the size has an eighth of the impulse and half the contact time") {
    const ParameterValues values;
    const auto whole = malletStrike({}, 100, 1, values);
    const auto half = malletStrike({}, 100, 0.5, values);
    CHECK(half.impulseNewtonSeconds[2] == Approx(whole.impulseNewtonSeconds[2] / 8));
    CHECK(half.durationSeconds == Approx(whole.durationSeconds / 2));
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
