// Tests the modes that a bow meets at a place: which they are, their poles and how they yield.
#include "Synth/PointModes.h"
#include "ModalReference.h"
#include "Synth/ContactWidth.h"
#include "Synth/Synthesiser.h"

#include <algorithm>
#include <array>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double rateHz = 48000;

Synthesiser synthesiserOf(ModalObject object) {
    return Synthesiser({{.object = std::make_shared<const ModalObject>(std::move(object))}},
                       rateHz);
}

ForcePlace at(const std::array<float, maximumShapeRows>& weights = {1}) {
    return {.points = {ForcePoint{.point = {.shapeRows = {0, 1}, .weights = weights}},
                       ForcePoint{.point = {.shapeRows = {2}}}}};
}

double hertz(const PointModes& modes, std::size_t i) {
    return std::arg(std::complex(modes.rotationRe[i], modes.rotationIm[i])) * rateHz /
           (2 * std::numbers::pi);
}

/// Returns the share of a mode's squared shape that counts at a ratio to the softest mode's
/// frequency.
double seen(double squaredShape, double ratio = 1) {
    return squaredShape * std::pow(ContactWidth::share(ratio), 2);
}

void beginCell(Synthesiser& synthesiser) {
    std::array<float, cellSamples> cell{};
    synthesiser.beginCell(CellOutput(cell));
}

} // namespace

TEST_CASE("The modes at a place have the poles and squared shapes of the object") {
    auto synthesiser = synthesiserOf(ringingObject({300, 900}, 20, {2, 3}));
    PointModes modes;
    beginCell(synthesiser);
    REQUIRE(synthesiser.findModes(0, at(), modes));
    REQUIRE(modes.count == 2);
    CHECK(hertz(modes, 0) == Approx(300).epsilon(1e-4));
    CHECK(hertz(modes, 1) == Approx(900).epsilon(1e-4));
    CHECK(modes.pushRe[0] == Approx(seen(4)));
    CHECK(modes.pushRe[1] == Approx(seen(9, 3)));
    CHECK(modes.mobilityPerKg() == Approx(seen(4) + seen(9, 3)));
    CHECK(modes.softestRadians == Approx(2 * std::numbers::pi * 300 / rateHz).epsilon(1e-4));
    CHECK(std::abs(std::complex(modes.rotationRe[1], modes.rotationIm[1])) ==
          Approx(std::exp(-10 / rateHz)));
}

TEST_CASE("The modes follow size, bend and place") {
    auto object = ringingObject({300, 900}, 20, {2, 2});
    object.shapes[2] = 4; // the first mode at the first vertex
    auto synthesiser = synthesiserOf(std::move(object));
    PointModes modes;
    SynthesisSettings settings;
    settings.sizeRatio = 2;
    synthesiser.setSettings(settings);
    synthesiser.setFrequencyRatio(0, 3);
    beginCell(synthesiser);
    REQUIRE(synthesiser.findModes(0, at(), modes));
    CHECK(hertz(modes, 0) == Approx(450).epsilon(1e-4));
    CHECK(modes.pushRe[0] == Approx(seen(16.0 / 8)));
    REQUIRE(synthesiser.findModes(0, at({0.5, 0.5}), modes));
    CHECK(modes.pushRe[0] == Approx(seen(9.0 / 8)));
    auto between = at();
    between.fraction = 0.25f;
    REQUIRE(synthesiser.findModes(0, between, modes));
    CHECK(modes.pushRe[0] == Approx(seen((0.75 * 16 + 0.25 * 4) / 8)));
    synthesiser.setFrequencyRatio(0, 2);
    beginCell(synthesiser);
    REQUIRE(synthesiser.findModes(0, between, modes));
    CHECK(hertz(modes, 0) == Approx(300).epsilon(1e-4));
}

TEST_CASE("Of many modes those are taken that yield most") {
    std::vector<double> hz;
    std::vector<float> gains;
    for (int mode = 0; mode < 100; ++mode) {
        hz.push_back(200 + 100 * mode);
        gains.push_back(mode % 3 == 0 ? 1.0f : 0.1f);
    }
    auto synthesiser = synthesiserOf(ringingObject(hz, 5, gains));
    PointModes modes;
    beginCell(synthesiser);
    REQUIRE(synthesiser.findModes(0, at(), modes));
    CHECK(modes.count == PointModes::capacity);
    CHECK(std::ranges::is_sorted(modes.numbers));
    for (const auto number : modes.numbers)
        CHECK(number % 3 == 0);
}

TEST_CASE("Invalid places have no modes") {
    auto synthesiser = synthesiserOf(ringingObject({300}));
    PointModes modes;
    CHECK_FALSE(synthesiser.findModes(1, at(), modes));
    auto wrong = at();
    wrong.points[0].point.shapeRows[0] = 9;
    CHECK_FALSE(synthesiser.findModes(0, wrong, modes));
    CHECK_FALSE(synthesiser.findModes(0, at({NAN}), modes));
    CHECK(modes.count == 0);
}

TEST_CASE("A contact's width halves a force at six times the softest frequency") {
    constexpr double softest = 0.02; // radians
    const auto gain = [](double radians) {
        ContactWidth width;
        std::array<float, cellSamples> newtons;
        std::complex<double> sum;
        for (std::size_t cell = 0; cell < 200; ++cell) {
            const auto angle = [&](std::size_t n) {
                return radians * static_cast<double>(cell * cellSamples + n);
            };
            for (std::size_t n = 0; n < newtons.size(); ++n)
                newtons[n] = static_cast<float>(std::cos(angle(n)));
            width.average(softest, newtons);
            for (std::size_t n = 0; n < newtons.size() && cell >= 100; ++n)
                sum += static_cast<double>(newtons[n]) * std::polar(2.0 / 6400, -angle(n));
        }
        return std::abs(sum);
    };
    for (const double ratio : {1.0, 4.0, 6.0})
        CHECK(gain(ratio * softest) == Approx(ContactWidth::share(ratio)).epsilon(0.02));
    CHECK(ContactWidth::share(ContactWidth::halvingRatio) == Approx(0.5));
}
