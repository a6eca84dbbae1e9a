#include "Parameters/Units.h"
#include "Parameters/ParameterTable.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <string>

using namespace idiophone;
using enum ParameterId;
using Catch::Approx;

namespace {

std::optional<double> typed(ParameterId parameter, std::string_view text) {
    return parseParameter(parameterInfo(parameter), text);
}

} // namespace

TEST_CASE("A number is converted between units of one quantity and refused between others") {
    CHECK(inUnit(1, "in", "mm") == Approx(25.4));
    CHECK(inUnit(5, "furlongs", "mm") == std::nullopt);
    CHECK(inUnit(5, "mm", "g") == std::nullopt);
    CHECK(inUnit(5, "steps", "steps") == 5.0);
    CHECK(inUnit(0.3, "kg/m3", "kg/m³") == 0.3); // the same unit changes no bit
}

TEST_CASE("A value is understood in every unit of its quantity") {
    struct Case {
        ParameterId parameter;
        const char* text;
        double value;
    };
    for (const auto& [parameter, text, value] : {Case{malletHardness, "0.2 GPa", 200},
                                                 {malletHardness, "3000kPa", 3},
                                                 {malletHardness, "5e6 Pa", 5},
                                                 {malletHardness, "20 N/mm²", 20},
                                                 {youngsModulus, "200 MPa", 0.2},
                                                 {youngsModulus, "25000 MPa", 25},
                                                 {malletRadius, "25 mm", 25},
                                                 {malletRadius, "1 in", 25.4},
                                                 {malletRadius, "1\"", 25.4},
                                                 {malletRadius, "2.5 cm", 25},
                                                 {malletRadius, "0.05 m", 50},
                                                 {malletMass, "30 g", 30},
                                                 {malletMass, "0.03 kg", 30},
                                                 {malletMass, "1 oz", 28.349523125},
                                                 {malletMass, "0.5 lb", 226.796185},
                                                 {releaseTime, "150 ms", 0.15},
                                                 {releaseTime, "0.05 min", 3},
                                                 {viscoelasticDamping, "0.002 ms", 2},
                                                 {viscoelasticDamping, "2e-6 s", 2},
                                                 {fluidDamping, "0.5 1/ms", 500},
                                                 {density, "7.85 g/cm³", 7850},
                                                 {density, "7.85 g/cm^3", 7850},
                                                 {density, "0.9 kg/l", 900},
                                                 {concertPitch, "0.442 kHz", 442},
                                                 {concertPitch, "442 hz", 442},
                                                 {tune, "2 semitones", 200},
                                                 {tune, "-1 semitone", -100},
                                                 {tune, "1 octave", 1200},
                                                 {bendRange, "1200 cents", 12},
                                                 {malletSpeed, "250 cm/s", 2.5},
                                                 {malletSpeed, "9 km/h", 2.5},
                                                 {contactForce, "0.05 kN", 50},
                                                 {motorSpeed, "180 rpm", 3},
                                                 {size, "200 %", 2},
                                                 {thickness, "2 ×", 200},
                                                 {lossFactor, "0.45 %", 0.0045},
                                                 {velocityCurve, "150%", 1.5},
                                                 {volume, "-6 dB", -6}}) {
        INFO(text);
        const auto read = typed(parameter, text);
        REQUIRE(read);
        CHECK(*read == Approx(value));
    }
}

TEST_CASE("A unit of another quantity is refused") {
    for (const auto& [parameter, text] : {std::pair(concertPitch, "3 kg"),
                                          {density, "3 kg"},
                                          {malletMass, "3 mm"},
                                          {volume, "50 %"},
                                          {tune, "5 Hz"},
                                          {fluidDamping, "5 Hz"},
                                          {releaseTime, "1/s"},
                                          {lossFactor, "3 dB"},
                                          {letRing, "50 %"},
                                          {material, "2 x"},
                                          {malletMass, "3 g g"}}) {
        INFO(text);
        CHECK_FALSE(typed(parameter, text));
    }
}

TEST_CASE("A comma stands for the decimal point, and groups of digits are refused") {
    CHECK(typed(density, "7,85 kg/l") == Approx(7850));
    CHECK(typed(density, "7,85kg/l") == Approx(7850));
    CHECK(typed(youngsModulus, "0,2") == Approx(0.2));
    CHECK(typed(tune, "-12,5 cents") == Approx(-12.5));
    CHECK_FALSE(typed(density, "7,850.5"));
    CHECK_FALSE(typed(density, "1,000,000 g/l"));
    CHECK_FALSE(typed(density, ",kg/l"));
}

TEST_CASE("An unclamped value keeps a number beyond the range, in any unit") {
    const auto& young = parameterInfo(youngsModulus);
    CHECK(parseUnclamped(young, "5e6 MPa") == Approx(5000));
    CHECK(parseParameter(young, "5e6 MPa") == young.maximum);
}

TEST_CASE("Figures of physics are shown and typed as 0 to 100 in the plain display") {
    constexpr auto plain = ValueDisplay::plain;
    for (const auto& info : parameterTable()) {
        INFO(info.id);
        if (!info.isPhysical) {
            CHECK(formatParameter(info, info.defaultValue, plain) ==
                  formatParameter(info, info.defaultValue));
            continue;
        }
        CHECK(formatParameter(info, info.minimum, plain) == "0");
        CHECK(formatParameter(info, info.maximum, plain) == "100");
        for (int place = 0; place <= 100; ++place) {
            const auto text = std::to_string(place);
            const auto value = parseParameter(info, text, plain);
            REQUIRE(value);
            CHECK(formatParameter(info, *value, plain) == text);
        }
        CHECK(parseParameter(info, "101", plain) == info.maximum);
        CHECK(parseParameter(info, "-3", plain) == Approx(info.minimum));
    }
    const auto& young = parameterInfo(youngsModulus);
    CHECK(parseParameter(young, "70 GPa", plain) == 70.0);
    CHECK(parseParameter(young, "500 MPa", plain) == Approx(0.5));
    CHECK_FALSE(parseParameter(young, "70 g", plain));
    CHECK_FALSE(parseParameter(young, "hard", plain));
    CHECK(parseParameter(parameterInfo(lossFactor), "0.45 %", plain) == Approx(0.0045));
    CHECK(parseParameter(parameterInfo(malletExponent), "2.5 x", plain) == 2.5);
}
