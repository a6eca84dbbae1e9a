#include "Plugin/SurfaceHand.h"
#include "Instrument/ObjectLibrary.h"

#include "Instrument/FactoryContent.h"
#include "Instrument/OwnSlots.h"
#include "Support/Level.h"
#include "Support/RenderNotes.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRateHz = 48000;

std::shared_ptr<const Instrument> instrumentOf(const char* preset) {
    return Instrument::build(findFactoryPreset(preset)->keyMap, ObjectLibrary::shared()).value();
}

void play(WindowEvents& events, Player* player) {
    events.read(player, [](const MidiEvent&) {});
}

float peakOf(Player& player) {
    return peak(renderStereo(player, {}, 4800, 480).left);
}

} // namespace

TEST_CASE("ownSlots lists every bar of a keyboard, but an object scaled to all keys only once") {
    CHECK(ownSlots(*instrumentOf("Rosewood Xylophone")).size() == 44);
    CHECK(ownSlots(*instrumentOf("Steel Plate")).size() == 1);
    const auto ring = instrumentOf("Steel Ring");
    const auto slots = ownSlots(*ring);
    REQUIRE(slots.size() == 1);
    for (const auto& slot : ring->slots())
        CHECK(std::abs(std::log2(slot.sizeRatio)) >=
              std::abs(std::log2(ring->slots()[slots[0]].sizeRatio)));
}

TEST_CASE("A strike reaches only the player of its instrument, at the aimed place") {
    const auto plate = instrumentOf("Steel Plate"), other = instrumentOf("Wok");
    WindowEvents events;
    SurfaceHand hand(events);
    Player onPlate(plate, sampleRateHz), onOther(other, sampleRateHz);
    hand.strike(plate, 0, {0.1, 0.05, 0.1}, 100);
    play(events, &onOther);
    CHECK(onOther.silent());
    play(events, &onPlate);
    CHECK(onPlate.silent()); // the strike was dropped

    hand.strike(plate, 0, {0.1, 0.05, 0.1}, 100);
    play(events, &onPlate);
    Player expected(plate, sampleRateHz);
    expected.strikeSurface(
        {.slot = 0,
         .point = ObjectSurface(*plate->slots()[0].object).nearest({0.1, 0.05, 0.1}),
         .velocity = 100});
    CHECK(renderStereo(onPlate, {}, 4800, 480) == renderStereo(expected, {}, 4800, 480));
    CHECK(peakOf(onPlate) > 0);
}

TEST_CASE("A drag goes straight to the next place in steps no longer than the mesh edges") {
    const auto plate = instrumentOf("Steel Plate");
    const ObjectSurface surface(*plate->slots()[0].object);
    const std::array<double, 3> from{-0.1, -0.05, 0.1}, to{0.1, 0.05, 0.1};
    WindowEvents events;
    SurfaceHand hand(events);
    hand.scrape(plate, 0, from, 1);
    hand.scrape(plate, 0, to, 1);
    Player byHand(plate, sampleRateHz), expected(plate, sampleRateHz);
    play(events, &byHand);
    const double edge = surface.meanEdgeMetres();
    const int steps = std::min(8, static_cast<int>(std::ceil(std::hypot(0.2, 0.1) / edge)));
    REQUIRE(steps > 1);
    for (int step = 0; step <= steps; ++step)
        expected.scrapeSurface({.slot = 0,
                                .point = surface.nearest({from[0] + 0.2 * step / steps,
                                                          from[1] + 0.1 * step / steps, 0.1}),
                                .pressure = 1});
    CHECK(renderStereo(byHand, {}, 9600, 480) == renderStereo(expected, {}, 9600, 480));
    CHECK(peakOf(byHand) > 0);
}

TEST_CASE("A lifted hand or a hand on another instrument starts a new drag") {
    const auto plate = instrumentOf("Steel Plate"), other = instrumentOf("Wok");
    WindowEvents events;
    SurfaceHand hand(events);
    hand.scrape(plate, 0, {-0.1, 0, 0.1}, 1);
    hand.scrape(other, 0, {0.1, 0, 0.1}, 1);
    Player onPlate(plate, sampleRateHz), onOther(other, sampleRateHz);
    play(events, &onOther);
    CHECK(onPlate.silent());
    CHECK(peak(renderStereo(onOther, {}, 9600, 480).left) == 0); // the contact rests
    hand.scrape(other, 0, {0.1, 0, 0.1}, 0);
    hand.scrape(other, 0, {-0.1, 0, 0.1}, 1);
    play(events, &onOther);
    CHECK(peak(renderStereo(onOther, {}, 9600, 480).left) == 0);
}

TEST_CASE("A hand is lifted even if the queue is full") {
    const auto plate = instrumentOf("Steel Plate");
    WindowEvents events;
    SurfaceHand hand(events);
    Player player(plate, sampleRateHz);
    for (int i = 0; i < 400; ++i)
        hand.scrape(plate, 0, {0.1, 0.05 + 1e-4 * i, 0.1}, 1);
    hand.scrape(plate, 0, {0.1, 0.05, 0.1}, 0);
    play(events, &player);
    renderStereo(player, {}, 48000, 480);
    ParameterValues damped;
    damped.set(ParameterId::letRing, 0);
    damped.set(ParameterId::releaseTime, 0.02);
    renderStereo(player, {}, 9600, 480, damped);
    CHECK(player.silent());
}

TEST_CASE("Without a player strikes are dropped, and their number is bounded") {
    const auto plate = instrumentOf("Steel Plate");
    WindowEvents events;
    SurfaceHand hand(events);
    for (int i = 0; i < 1000; ++i)
        hand.strike(plate, 0, {0, 0, 0}, 100);
    play(events, nullptr);
    Player player(plate, sampleRateHz);
    play(events, &player);
    CHECK(player.silent());
}
