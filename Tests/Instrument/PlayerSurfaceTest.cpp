// Tests strikes on an object's surface without a key.
#include "Instrument/Player.h"
#include "Support/AllocationCounter.h"
#include "Support/Level.h"
#include "Support/RenderNotes.h"
#include "TestInstruments.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

namespace {

constexpr double sampleRateHz = 48000;

ParameterValues steadyHand() {
    ParameterValues parameters;
    parameters.set(strikeSpread, 0);
    parameters.set(letRing, 0);
    parameters.set(releaseTime, 0.05);
    return parameters;
}

/// Returns a strike at the place where a key strikes.
SurfaceStrike strikeOf(const Instrument& instrument, int note, int velocity) {
    const auto& key = instrument.key(note);
    return {.slot = static_cast<std::size_t>(key.slot),
            .point = key.strip->between(key.along, 0).point,
            .velocity = velocity};
}

} // namespace

TEST_CASE(
    "A surface strike at a key's place equals the key's strike bit for bit in all block sizes") {
    const auto instruments = {bars(),
                              keysOn(syntheticObject({200, 520}), KeyMapKind::scaled, 48, 72)};
    for (const auto& instrument : instruments) {
        Player byKey(instrument, sampleRateHz);
        const auto expected = renderStereo(byKey, {midi(0, 0x90, 65, 90)}, 8000, 480, steadyHand());
        CHECK(peak(expected.left) > 0);
        for (const std::size_t blockSize : {1, 64, 500, 8000}) {
            Player byHand(instrument, sampleRateHz);
            byHand.strikeSurface(strikeOf(*instrument, 65, 90));
            CHECK_FALSE(byHand.silent());
            CHECK(renderStereo(byHand, {}, 8000, blockSize, steadyHand()) == expected);
        }
    }
}

TEST_CASE("A hand on the surface holds the object until it lifts, as a key does") {
    const auto instrument = bars();
    Player player(instrument, sampleRateHz);
    auto strike = strikeOf(*instrument, 65, 90);
    player.strikeSurface(strike);
    const auto held = renderStereo(player, {}, 9600, 480, steadyHand());
    strike.velocity = 0;
    player.strikeSurface(strike);
    const auto lifted = renderStereo(player, {}, 9600, 480, steadyHand());
    CHECK(rms(std::span(held.left).last(480)) > 0.3 * rms(std::span(held.left).first(480)));
    CHECK(rms(std::span(lifted.left).last(480)) < 1e-3 * rms(std::span(held.left).first(480)));
}

TEST_CASE("All Sound Off ends surface strikes, and a reset forgets a pending one") {
    const auto instrument = bars();
    Player player(instrument, sampleRateHz);
    player.strikeSurface(strikeOf(*instrument, 65, 90));
    const auto sound = renderStereo(player, {midi(480, 0xb0, 120, 0)}, 4800, 480, steadyHand());
    CHECK(peak(std::span(sound.left).last(480)) < 1e-5f * peak(sound.left));
    player.strikeSurface(strikeOf(*instrument, 65, 90));
    player.reset();
    CHECK(player.silent());
}

TEST_CASE("A strike on a missing slot or row is ignored") {
    const auto instrument = bars();
    Player player(instrument, sampleRateHz);
    for (const auto& [slot, row] :
         {std::pair<std::size_t, std::int32_t>{13, 0}, {std::size_t(-1), 0}, {0, 4}, {0, -1}}) {
        auto strike = strikeOf(*instrument, 60, 100);
        strike.slot = slot;
        strike.point.shapeRows[0] = row;
        player.strikeSurface(strike);
    }
    CHECK(player.silent());
    CHECK(peak(renderStereo(player, {}, 480, 480).left) == 0);
}

TEST_CASE("Strikes beyond the capacity between two blocks are dropped without allocating") {
    const auto instrument = bars();
    Player player(instrument, sampleRateHz);
    const auto strike = strikeOf(*instrument, 65, 90);
    const AllocationCounter allocations;
    for (int i = 0; i < 1000; ++i)
        player.strikeSurface(strike);
    CHECK(allocations.allocations() == 0);
}

TEST_CASE("A surface strike that is not finite makes no sound and leaves nothing pending") {
    Player player(bars(), sampleRateHz);
    auto strike = strikeOf(player.instrument(), 65, 90);
    strike.point.normal[1] = std::numeric_limits<float>::quiet_NaN();
    player.strikeSurface(strike);
    const auto sound = renderStereo(player, {}, 9600, 480, steadyHand());
    CHECK(peak(sound.left) == 0);
    CHECK(player.silent());
}
