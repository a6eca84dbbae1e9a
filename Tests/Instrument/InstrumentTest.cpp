#include "Instrument/Instrument.h"
#include "Instrument/ObjectLibrary.h"
#include "Support/SyntheticObject.h"

#include <array>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace idiophone;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;
using test::syntheticObject;

namespace {

/// A key map without resized keys.
KeyMap keyMap(KeyMapKind kind, int lowest, int highest, std::string object) {
    KeyMap map;
    map.resizedFrom = 1;
    map.resizedTo = 0;
    map.kind = kind;
    map.lowestNote = lowest;
    map.highestNote = highest;
    map.object = std::move(object);
    return map;
}

double weightOf(const StrikePoint& point, int row) {
    double sum = 0;
    for (std::size_t k = 0; k < maximumShapeRows; ++k)
        if (point.shapeRows[k] == row)
            sum += static_cast<double>(point.weights[k]);
    return sum;
}

} // namespace

TEST_CASE("Every instrument has its own serial number, on a stage too") {
    ObjectLibrary library;
    const auto kept = library.add("bar", syntheticObject({261.6}));
    const auto map = keyMap(KeyMapKind::zones, 60, 61, "bar");
    const auto first = Instrument::build(map, library), second = Instrument::build(map, library);
    REQUIRE((first && second));
    CHECK((*first)->serialNumber() != 0);
    CHECK((*second)->serialNumber() != (*first)->serialNumber());
    std::array<int, 128> silent;
    silent.fill(-1);
    const auto onStage = Instrument::onStage(map, {}, silent, nullptr);
    CHECK(onStage->serialNumber() != (*second)->serialNumber());
}

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

TEST_CASE("Keys that share an object share its strip") {
    ObjectLibrary library;
    const auto all = library.add("all", syntheticObject({440}));
    const auto one = library.add("bar-60", syntheticObject({262}));
    const auto same = Instrument::build(keyMap(KeyMapKind::bars, 0, 127, "all"), library).value();
    for (int note = 0; note < 128; ++note) {
        CHECK(same->key(note).slot == note);
        CHECK(same->key(note).strip == same->key(0).strip);
    }
    library.add("bar-61", all);
    library.add("bar-62", one);
    const auto bars =
        Instrument::build(keyMap(KeyMapKind::bars, 60, 62, "bar-{note}"), library).value();
    CHECK(bars->key(60).strip == bars->key(62).strip);
    CHECK(bars->key(60).strip != bars->key(61).strip);
}

TEST_CASE("An instrument has a maximum number of modes on all keys together") {
    ObjectLibrary library;
    const auto kept =
        library.add("crowd", syntheticObject(std::vector<double>(maximumObjectModes, 440.0)));
    const auto most = static_cast<int>(maximumModesOfSlots / maximumObjectModes);
    for (const auto kind : {KeyMapKind::bars, KeyMapKind::scaled}) {
        CHECK(Instrument::build(keyMap(kind, 0, most - 1, "crowd"), library));
        const auto built = Instrument::build(keyMap(kind, 0, most, "crowd"), library);
        REQUIRE_FALSE(built);
        CHECK(built.error().message == "'crowd' has 2162688 modes on all keys together, more than "
                                       "the 2097152 that can be played");
    }
    CHECK(Instrument::build(keyMap(KeyMapKind::zones, 0, 127, "crowd"), library));
}

TEST_CASE("An instrument has a maximum number of slots, however few modes they have") {
    const SynthesiserSlot slot{.object =
                                   std::make_shared<const ModalObject>(syntheticObject({440}))};
    std::vector<SynthesiserSlot> slots(maximumSlots, slot);
    CHECK(boundedSlots(slots, "heap.jsonl", "bodies"));
    slots.push_back(slot);
    const auto bounded = boundedSlots(slots, "heap.jsonl", "bodies");
    REQUIRE_FALSE(bounded);
    CHECK(bounded.error().message ==
          "heap.jsonl has 65537 bodies, more than the 65536 that can be played");
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
        const auto place = key.strip->between(key.along, 0).point;
        CHECK(weightOf(place, note - 60) > 0.98); // the table's step cuts the path's corners
    }
}

TEST_CASE("Scaled keys resize the object so that its lowest mode has the key's pitch") {
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
    CHECK(instrument.key(81).mallet.scale == sizeOf(81));
}

TEST_CASE("The strike position across reaches the edges beside the path") {
    ObjectLibrary library;
    const auto kept = library.add("square", syntheticObject({200}));
    auto map = keyMap(KeyMapKind::zones, 60, 61, "square");
    map.strikePath = {{-1, 0, 0}, {1, 0, 0}};
    const auto instrument = Instrument::build(map, library);
    REQUIRE(instrument);
    const auto& strip = *(*instrument)->key(60).strip;
    CHECK(weightOf(strip.between(0, -1).point, 0) == Approx(1));
    CHECK(weightOf(strip.between(0, 1).point, 3) == Approx(1));
    CHECK(weightOf(strip.between(1, -1).point, 1) == Approx(1));
    CHECK(weightOf(strip.between(1, 1).point, 2) == Approx(1));
    CHECK(weightOf(strip.between(7, 9).point, 2) == Approx(1));
    CHECK(strip.between(0, 0).point.normal[2] == Approx(1));
}

TEST_CASE("The length of a strike path is in metres") {
    ObjectLibrary library;
    const auto kept = library.add("square", syntheticObject({100}));
    const auto square = Instrument::build({.kind = KeyMapKind::zones,
                                           .object = "square",
                                           .strikePath = {{-1, -1, 0}, {1, -1, 0}, {1, 0, 0}}},
                                          library)
                            .value();
    CHECK(square->key(60).strip->lengthMetres == Approx(1.5));
}

TEST_CASE("The error for a missing object names it") {
    ObjectLibrary library;
    const auto built =
        Instrument::build(keyMap(KeyMapKind::zones, 60, 61, "no/such.modal"), library);
    REQUIRE_FALSE(built);
    CHECK_THAT(built.error().message, ContainsSubstring("no/such.modal"));
}

TEST_CASE("The library returns the same object to all callers while it is in use") {
    ObjectLibrary library;
    auto first = library.add("a", syntheticObject({100}));
    CHECK(library.find("a").value() == first);
    first.reset();
    CHECK_FALSE(library.find("a"));
}
