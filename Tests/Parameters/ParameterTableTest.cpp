#include "Parameters/ParameterTable.h"
#include "Object/Material.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>
#include <locale>
#include <set>

using namespace idiophone;
using Catch::Approx;

TEST_CASE("Ids are unique, and every default is in its range") {
    std::set<std::string_view> ids;
    for (const auto& info : parameterTable()) {
        INFO(info.id);
        CHECK(ids.insert(info.id).second);
        CHECK(info.minimum < info.maximum);
        CHECK(info.clamped(info.defaultValue) == info.defaultValue);
        CHECK(findParameter(info.id) == &info);
        CHECK_FALSE(std::string_view(info.description).empty());
    }
    CHECK(findParameter("no such id") == nullptr);
}

TEST_CASE("The normalised range covers all values in both directions") {
    for (const auto& info : parameterTable()) {
        INFO(info.id);
        CHECK(info.fromNormalised(0) == Approx(info.minimum));
        CHECK(info.fromNormalised(1) == Approx(info.maximum));
        CHECK(info.toNormalised(info.minimum) == Approx(0).margin(1e-12));
        CHECK(info.toNormalised(info.maximum) == Approx(1));
        for (double normalised = 0; normalised <= 1; normalised += 0.01) {
            const double value = info.fromNormalised(normalised);
            CHECK(info.fromNormalised(info.toNormalised(value)) == Approx(value));
        }
    }
}

TEST_CASE("Values out of range and NaN are clamped") {
    for (const auto& info : parameterTable()) {
        INFO(info.id);
        const double infinity = std::numeric_limits<double>::infinity();
        CHECK(info.clamped(infinity) == info.maximum);
        CHECK(info.clamped(-infinity) == info.minimum);
        CHECK(info.clamped(std::nan("")) == info.defaultValue);
        CHECK(info.fromNormalised(std::nan("")) == Approx(info.defaultValue).margin(1e-12));
        CHECK(info.fromNormalised(2) == Approx(info.maximum));
    }
}

TEST_CASE("Formatted text is parsed to the same digits") {
    for (const auto& info : parameterTable())
        for (double normalised = 0; normalised <= 1; normalised += 0.05) {
            const double value = info.fromNormalised(normalised);
            const auto text = formatParameter(info, value);
            INFO(info.id << ": " << text);
            const auto typed = parseParameter(info, text);
            REQUIRE(typed);
            CHECK(formatParameter(info, *typed) == text);
        }
}

TEST_CASE("A value that rounds to zero has no sign") {
    const auto& level = parameterInfo(ParameterId::level);
    CHECK(formatParameter(level, -0.04) == "0.0 dB");
    CHECK(formatParameter(level, -0.06) == "-0.1 dB");
    CHECK(formatParameter(level, -20) == "-20.0 dB");
}

TEST_CASE("Typed units and names are accepted, and other text is refused") {
    const auto& young = parameterInfo(ParameterId::youngsModulus);
    CHECK(parseParameter(young, " 70 gpa ") == 70.0);
    CHECK(parseParameter(young, "70") == 70.0);
    CHECK_FALSE(parseParameter(young, "70 Hz"));
    CHECK_FALSE(parseParameter(young, "stiff"));
    CHECK_FALSE(parseParameter(young, ""));
    CHECK_FALSE(parseParameter(young, "nan"));
    const auto& slope = parameterInfo(ParameterId::qualitySlope);
    CHECK(parseParameter(slope, "greedy") == slope.maximum);
    CHECK(formatParameter(slope, slope.maximum) == "Greedy");
    CHECK(parseParameter(parameterInfo(ParameterId::letRing), "off") == 0.0);
    CHECK(parseParameter(parameterInfo(ParameterId::material), "Custom") ==
          static_cast<double>(customMaterial));
}

TEST_CASE("A loss factor can be set from bell glass to rubber and typed as papers print it") {
    const auto& loss = parameterInfo(ParameterId::lossFactor);
    CHECK(formatParameter(loss, 0) == "0");
    CHECK(formatParameter(loss, 2.5e-5) == "0.0000250");
    CHECK(formatParameter(loss, 0.035) == "0.0350");
    CHECK(parseParameter(loss, "2.5e-5") == 2.5e-5);
    CHECK(loss.fromNormalised(0) == 0);
    CHECK(loss.fromNormalised(1e-5) == 0); // avoids a text of a hundred digits
    CHECK(formatParameter(loss, loss.fromNormalised(0.008)).size() <= 12);
    // A slider of a few hundred pixels separates neighbouring metals.
    CHECK(loss.toNormalised(2e-4) - loss.toNormalised(1e-4) > 0.01);
    CHECK(loss.toNormalised(2.5e-5) > 0.03);
}

TEST_CASE("Numbers have a decimal point in every locale of the host") {
    struct DecimalComma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const auto before = std::locale::global(std::locale(std::locale(), new DecimalComma));
    const auto& young = parameterInfo(ParameterId::youngsModulus);
    const auto shown = formatParameter(young, 12.5);
    const auto hundreds = formatParameter(parameterInfo(ParameterId::density), 12500);
    const auto typed = parseParameter(young, "12.5");
    std::locale::global(before);
    CHECK(shown == "12.50 GPa");
    CHECK(hundreds == "12500 kg/m³");
    CHECK(typed == 12.5);
}

TEST_CASE("Units can be typed on any keyboard") {
    const auto& density = parameterInfo(ParameterId::density);
    for (const char* text : {"900", "900 kg/m3", "900 kg/m³", "900KG/M3"})
        CHECK(parseParameter(density, text) == 900.0);
    CHECK_FALSE(parseParameter(density, "900 kg/m"));
    const auto& eta = parameterInfo(ParameterId::viscoelasticDamping);
    for (const char* text : {"2 us", "2 µs", "2 μs"}) // the micro sign and the Greek letter
        CHECK(parseParameter(eta, text) == 2.0);
    CHECK(formatParameter(eta, 2) == "2.000 µs");
    CHECK(parseParameter(parameterInfo(ParameterId::size), "2x") == 2.0);
}

TEST_CASE("The material choice names the library's materials in the library's order") {
    const auto names = choiceNames(ParameterId::material);
    const auto library = materialLibrary();
    REQUIRE(names.size() == library.size() + firstLibraryMaterial);
    for (std::size_t i = 0; i < library.size(); ++i)
        CHECK(names[i + firstLibraryMaterial] == library[i].name);
}

TEST_CASE("Mallets are formatted and parsed by their names") {
    const auto& mallet = parameterInfo(ParameterId::mallet);
    CHECK(formatParameter(mallet, customMallet) == "Custom");
    CHECK(parseParameter(mallet, "hard plastic") == 6.0);
}
