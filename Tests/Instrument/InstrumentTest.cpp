#include "Instrument/Instrument.h"
#include "Support/SyntheticObject.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace idiophone;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;
using test::syntheticObject;

namespace {

KeyMap keyMap(KeyMapKind kind, int lowest, int highest, std::string object) {
    KeyMap map;
    map.kind = kind;
    map.lowestNote = lowest;
    map.highestNote = highest;
    map.object = std::move(object);
    return map;
}

} // namespace

TEST_CASE("Bars give every key an object of its own") {
    ObjectLibrary library;
    const auto a = library.add("bar-60", syntheticObject({261.6}));
    const auto b = library.add("bar-61", syntheticObject({277.2}));
    const auto instrument =
        Instrument::build(keyMap(KeyMapKind::bars, 60, 61, "bar-{note}"), library);
    REQUIRE(instrument);
    REQUIRE((*instrument)->slots().size() == 2);
    CHECK((*instrument)->slots()[0].object == a);
    CHECK((*instrument)->slots()[1].object == b);
    CHECK((*instrument)->key(60).slot == 0);
    CHECK((*instrument)->key(61).slot == 1);
    CHECK((*instrument)->key(59).slot == -1);
    CHECK((*instrument)->key(62).slot == -1);
}

TEST_CASE("Zones move the strike along the path as the keys go up") {
    ObjectLibrary library;
    const auto kept = library.add("square", syntheticObject({200}));
    auto map = keyMap(KeyMapKind::zones, 60, 63, "square");
    map.strikePath = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    const auto built = Instrument::build(map, library);
    REQUIRE(built);
    const auto& instrument = **built;
    REQUIRE(instrument.slots().size() == 1);
    for (int note = 60; note <= 63; ++note) {
        const auto& key = instrument.key(note);
        CHECK(key.slot == 0);
        // The path visits the square's four corners, which are the rows 0 to 3.
        CHECK(instrument.strip(key).at(key.along, 0).shapeRows[0] == note - 60);
    }
}

TEST_CASE("Scaled keys resize the object so that its lowest mode sounds the key") {
    ObjectLibrary library;
    const auto kept = library.add("thing", syntheticObject({440, 1000}));
    const auto built = Instrument::build(keyMap(KeyMapKind::scaled, 57, 81, "thing"), library);
    REQUIRE(built);
    const auto& instrument = **built;
    CHECK(instrument.slots().size() == 25);
    const auto sizeOf = [&](int note) {
        return instrument.slots()[static_cast<std::size_t>(instrument.key(note).slot)].sizeRatio;
    };
    CHECK(sizeOf(69) == Approx(1).epsilon(1e-5));
    CHECK(sizeOf(57) == Approx(2).epsilon(1e-5));
    CHECK(sizeOf(81) == Approx(0.5).epsilon(1e-5));
    CHECK(instrument.key(81).malletScale == sizeOf(81));
}

TEST_CASE("Strike position across reaches the edges beside the path") {
    ObjectLibrary library;
    const auto kept = library.add("square", syntheticObject({200}));
    auto map = keyMap(KeyMapKind::zones, 60, 61, "square");
    map.strikePath = {{-1, 0, 0}, {1, 0, 0}};
    const auto instrument = Instrument::build(map, library);
    REQUIRE(instrument);
    const auto& strip = (*instrument)->strip((*instrument)->key(60));
    CHECK(strip.at(0, -1).shapeRows[0] == 0);
    CHECK(strip.at(0, 1).shapeRows[0] == 3);
    CHECK(strip.at(1, -1).shapeRows[0] == 1);
    CHECK(strip.at(1, 1).shapeRows[0] == 2);
    CHECK(strip.at(7, 9).shapeRows[0] == 2);
    CHECK(strip.at(0, 0).normal[2] == Approx(1));
}

TEST_CASE(
    "Between two points of the strip the place is their mean, and the path lies in the surface") {
    const auto plate = Instrument::build({.kind = KeyMapKind::zones,
                                          .object = "plate",
                                          .strikePath = {{-1, -1, 0}, {1, 1, 0}},
                                          .strikeWidth = 0.6},
                                         ObjectLibrary::shared())
                           .value();
    const auto& strip = plate->strip(plate->key(60));
    int mixed = 0;
    for (int i = 0; i + 1 < strip.alongCount; ++i) {
        const double step = 1.0 / (strip.alongCount - 1);
        const auto& first = strip.at(i * step, 0.4);
        const auto& second = strip.at((i + 1) * step, 0.4);
        const auto place = strip.between((i + 0.25) * step, 0.4);
        REQUIRE(place.point.shapeRows[0] == first.shapeRows[0]);
        if (first.shapeRows[0] == second.shapeRows[0]) {
            REQUIRE(place.point.weights[0] == 1);
        } else {
            REQUIRE(place.point.shapeRows[1] == second.shapeRows[0]);
            REQUIRE(place.point.weights[0] == Approx(0.75));
            REQUIRE(place.point.weights[1] == Approx(0.25));
            ++mixed;
        }
        const auto& normal = place.point.normal;
        const auto& direction = place.direction;
        REQUIRE(std::hypot(direction[0], direction[1], direction[2]) == Approx(1));
        REQUIRE(std::hypot(normal[0], normal[1], normal[2]) == Approx(1));
        REQUIRE(std::abs(normal[0] * direction[0] + normal[1] * direction[1] +
                         normal[2] * direction[2]) < 1e-3f);
        REQUIRE(direction[0] > 0);
    }
    CHECK(mixed > 10);
    CHECK(strip.between(2, 0).point.shapeRows == strip.between(1, 0).point.shapeRows);
    const auto end = strip.between(1, 0).point;
    CHECK(end.shapeRows[end.weights[1] > 0.5f ? 1 : 0] == strip.at(1, 0).shapeRows[0]);
}

TEST_CASE("The length of a strike path is in metres") {
    ObjectLibrary library;
    const auto kept = library.add("square", syntheticObject({100}));
    const auto square = Instrument::build({.kind = KeyMapKind::zones,
                                           .object = "square",
                                           .strikePath = {{-1, -1, 0}, {1, -1, 0}, {1, 0, 0}}},
                                          library)
                            .value();
    CHECK(square->strip(square->key(60)).lengthMetres == Approx(1.5));
}

TEST_CASE("An instrument whose object is missing says which") {
    ObjectLibrary library;
    const auto built =
        Instrument::build(keyMap(KeyMapKind::zones, 60, 61, "no/such.modal"), library);
    REQUIRE_FALSE(built);
    CHECK_THAT(built.error().message, ContainsSubstring("no/such.modal"));
}

TEST_CASE("Everybody who asks for an object gets the same one, for as long as it is used") {
    ObjectLibrary library;
    auto first = library.add("a", syntheticObject({100}));
    CHECK(library.find("a").value() == first);
    first.reset();
    CHECK_FALSE(library.find("a"));
}
