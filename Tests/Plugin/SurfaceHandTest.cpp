#include "Plugin/SurfaceHand.h"

#include "Instrument/FactoryContent.h"
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

float peakOf(Player& player) {
    return peak(renderStereo(player, {}, 4800, 480).left);
}

} // namespace

TEST_CASE("A bar a key are as many objects, a ring scaled to every key is one") {
    CHECK(ownSlots(*instrumentOf("Rosewood Xylophone")).size() == 44);
    CHECK(ownSlots(*instrumentOf("Steel Plate")).size() == 1);
    const auto ring = instrumentOf("Steel Ring");
    const auto slots = ownSlots(*ring);
    REQUIRE(slots.size() == 1);
    for (const auto& slot : ring->slots())
        CHECK(std::abs(std::log2(slot.sizeRatio)) >=
              std::abs(std::log2(ring->slots()[slots[0]].sizeRatio)));
}

TEST_CASE("A blow reaches the player of its instrument, where it was aimed, and no other") {
    const auto plate = instrumentOf("Steel Plate"), other = instrumentOf("Wok");
    SurfaceHand hand;
    Player onPlate(plate, sampleRateHz), onOther(other, sampleRateHz);
    hand.strike(plate, 0, {0.1, 0.05, 0.1}, 100);
    hand.strikeOn(&onOther);
    CHECK(onOther.silent());
    hand.strikeOn(&onPlate);
    CHECK(onPlate.silent()); // it was dropped

    hand.strike(plate, 0, {0.1, 0.05, 0.1}, 100);
    hand.strikeOn(&onPlate);
    Player expected(plate, sampleRateHz);
    expected.strikeSurface(
        {.slot = 0,
         .point = ObjectSurface(*plate->slots()[0].object).nearest({0.1, 0.05, 0.1}),
         .velocity = 100});
    CHECK(renderStereo(onPlate, {}, 4800, 480) == renderStereo(expected, {}, 4800, 480));
    CHECK(peakOf(onPlate) > 0);
}

TEST_CASE("Without a player blows are dropped, and a flood of them is bounded") {
    const auto plate = instrumentOf("Steel Plate");
    SurfaceHand hand;
    for (int i = 0; i < 1000; ++i)
        hand.strike(plate, 0, {0, 0, 0}, 100);
    hand.strikeOn(nullptr);
    Player player(plate, sampleRateHz);
    hand.strikeOn(&player);
    CHECK(player.silent());
}
