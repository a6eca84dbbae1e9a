// Tests that a host's blocks leave no trace in the sound, and that notes start at their sample.
#include "BusyKeys.h"
#include "SameInAllBlocks.h"
#include "Support/Level.h"
#include "Support/RenderNotes.h"
#include "Support/RigidBall.h"
#include "TestInstruments.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRateHz = 48000;

} // namespace

TEST_CASE("Renders are bit-identical for block sizes 1, 7, 64, 480 and 4096") {
    ParameterValues parameters;
    parameters.set(ParameterId::letRing, 0);
    const auto sound = checkSameInBlocksOf({1, 7, 64, 480, 4096}, bars(), sampleRateHz,
                                           busyEvents(30000), 30000, parameters);
    CHECK(peak(sound.left) > 0.001f);
}

TEST_CASE("Stereo renders are bit-identical for block sizes 1, 7, 64, 480 and 4096") {
    ParameterValues parameters;
    parameters.set(ParameterId::radiation, 60);
    parameters.set(ParameterId::letRing, 0);
    const auto sound = checkSameInBlocksOf({1, 7, 64, 480, 4096}, bars(), sampleRateHz,
                                           busyEvents(20000), 20000, parameters);
    CHECK(peak(sound.left) > 0.001f);
    CHECK(sound.left != sound.right);
}

TEST_CASE("Clicks of a rigid body are bit-identical for block sizes 1, 7, 64, 480 and 4096") {
    ParameterValues parameters;
    parameters.set(ParameterId::radiation, 60);
    const auto sound = checkSameInBlocksOf({1, 7, 64, 480, 4096},
                                           keysOn(rigidBall(0.02, 2500), KeyMapKind::zones, 60, 72),
                                           sampleRateHz, busyEvents(10000), 10000, parameters);
    CHECK(peak(sound.left) > 1e-4f);
}

TEST_CASE("After a reset the same events give the same bits") {
    Player player(bars(), sampleRateHz);
    const auto events = busyEvents(10000);
    const auto first = render(player, events, 10000, 100);
    player.reset();
    CHECK(player.silent());
    CHECK(render(player, events, 10000, 100) == first);
}

TEST_CASE("A note starts exactly at its sample") {
    const int start = GENERATE(0, 1, 63, 64, 65, 1000);
    Player player(bars(), sampleRateHz);
    const auto sound = render(player, {midi(start, 0x90, 69, 127)}, 2000, 333);
    CHECK(peak(std::span(sound).first(static_cast<std::size_t>(start))) == 0);
    CHECK(peak(std::span(sound).subspan(static_cast<std::size_t>(start), 8)) > 0);
}

TEST_CASE("A note of an empty block, or beyond a block's end, starts the next block") {
    const auto instrument = bars();
    Player expected(instrument, sampleRateHz);
    auto sound = render(expected, {}, 100, 100);
    const auto after = render(expected, {midi(0, 0x90, 69, 100)}, 4800, 480);
    CHECK(peak(after) > 0.001f);

    Player empty(instrument, sampleRateHz);
    render(empty, {}, 100, 100);
    const std::array note{midi(0, 0x90, 69, 100)};
    empty.process(StereoSound(0), note, {});
    CHECK_FALSE(empty.silent());
    CHECK(render(empty, {}, 4800, 480) == after);

    Player beyond(instrument, sampleRateHz);
    StereoSound block(100);
    const std::array lateNote{midi(100, 0x90, 69, 100)};
    beyond.process(block, lateNote, {});
    CHECK(peak(block.left) == 0);
    CHECK(render(beyond, {}, 4800, 480) == after);

    Player silenced(instrument, sampleRateHz);
    const std::array both{midi(0, 0x90, 69, 100), midi(0, 0xb0, 120, 0)};
    silenced.process(StereoSound(0), both, {});
    CHECK(silenced.silent());
}
