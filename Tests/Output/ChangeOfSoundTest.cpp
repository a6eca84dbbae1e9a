// Tests the level when one sound replaces another.
#include "Output/StageSounds.h"

#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

ParameterValues inRoom(double levelDecibels) {
    auto values = valuesWith(levelDecibels);
    values.set(ParameterId::room, 100);
    values.set(ParameterId::roomDecay, 3);
    return values;
}

} // namespace

TEST_CASE("Another sound starts at its own level, whatever the old level") {
    const double before = GENERATE(-60.0, -41.0, 5.0, 24.0),
                 now = GENERATE(-60.0, -41.0, 5.0, 24.0);
    PreparedStage stage;
    const std::vector<float> ones(700, 1.0f);
    processed(stage, ones, 100, valuesWith(before));
    SECTION("at rest") {}
    SECTION("while the level still moves") {
        processed(stage, ones, 100, valuesWith(before - 3));
    }
    const float last = processed(stage, {1.0f}, 1, valuesWith(before)).front();
    const float levelBefore = stage.changeSound(valuesWith(now));
    for (const float sample : processed(stage, ones, 100, valuesWith(now))) {
        REQUIRE_THAT(sample, WithinRel(std::pow(10, now / 20), 1e-5));
        REQUIRE_THAT(levelBefore * sample, WithinRel(last, 1e-5f));
    }
}

TEST_CASE("Reverb of an old sound keeps its level through automation and further changes") {
    const std::size_t blockSize = GENERATE(64, 480);
    const Stereo burst{sine(4800), sine(4800, 700)}, other{sine(4800, 230), sine(4800, 310)},
        nothing{std::vector<float>(4800), std::vector<float>(4800)};
    constexpr std::array levels{-41.0, 5.0, -55.0};
    // The mixture is the sum of each sound alone from its own time on.
    Stereo expected{std::vector<float>(4 * 4800), std::vector<float>(4 * 4800)};
    for (std::size_t sound = 0; sound < levels.size(); ++sound) {
        PreparedStage alone;
        for (std::size_t part = sound; part < 4; ++part) {
            const auto heard = processed(alone,
                                         part > sound     ? nothing
                                         : sound % 2 == 0 ? burst
                                                          : other,
                                         blockSize, inRoom(levels[sound]));
            for (std::size_t i = 0; i < 4800; ++i) {
                expected.left[part * 4800 + i] += heard.left[i];
                expected.right[part * 4800 + i] += heard.right[i];
            }
        }
    }
    PreparedStage stage;
    Stereo all;
    for (std::size_t part = 0; part < 4; ++part) {
        const auto values = inRoom(levels[std::min<std::size_t>(part, 2)]);
        if (part == 1 || part == 2)
            stage.changeSound(values);
        const auto heard = processed(stage,
                                     part == 3       ? nothing
                                     : part % 2 == 0 ? burst
                                                     : other,
                                     blockSize, values);
        all.left.insert(all.left.end(), heard.left.begin(), heard.left.end());
        all.right.insert(all.right.end(), heard.right.begin(), heard.right.end());
    }
    for (std::size_t i = 0; i < all.left.size(); ++i) {
        REQUIRE_THAT(all.left[i], WithinAbs(expected.left[i], 1e-5));
        REQUIRE_THAT(all.right[i], WithinAbs(expected.right[i], 1e-5));
    }

    // The level parameter still controls the whole sound.
    PreparedStage fresh;
    const auto quieter = inRoom(-20);
    processed(stage, nothing, blockSize, quieter);
    processed(fresh, nothing, blockSize, quieter);
    stage.changeSound(quieter); // during the reverb
    const auto dry = valuesWith(-30);
    processed(stage, nothing, blockSize, dry);
    processed(fresh, nothing, blockSize, dry);
    const auto got = processed(stage, burst, blockSize, dry),
               wanted = processed(fresh, burst, blockSize, dry);
    for (std::size_t i = 0; i < got.left.size(); ++i)
        REQUIRE_THAT(got.left[i], WithinAbs(wanted.left[i], 1e-7));
}

TEST_CASE("A level raised after a change is reached and does not raise old reverb") {
    PreparedStage stage, alone;
    const Stereo burst{sine(4800), sine(4800, 700)};
    const Stereo nothing{std::vector<float>(9600), std::vector<float>(9600)};
    processed(stage, burst, 480, inRoom(-5));
    processed(alone, burst, 480, inRoom(-5));
    stage.changeSound(inRoom(-55));
    processed(stage, Stereo{std::vector<float>(64), std::vector<float>(64)}, 64, inRoom(-55));
    processed(alone, Stereo{std::vector<float>(64), std::vector<float>(64)}, 64, inRoom(-5));
    // A host may continue its automation at the old level.
    const auto tail = processed(stage, nothing, 480, inRoom(-5)),
               expected = processed(alone, nothing, 480, inRoom(-5));
    for (std::size_t i = 0; i < tail.left.size(); ++i)
        REQUIRE_THAT(tail.left[i], WithinAbs(expected.left[i], 1e-5));
    // Lowering the level lowers the reverb too.
    processed(stage, nothing, 480, inRoom(-50));
    processed(alone, nothing, 480, inRoom(-50));
    processed(stage, nothing, 480, valuesWith(-50));
    const auto dry = processed(stage, burst, 480, valuesWith(6));
    const auto gain = static_cast<float>(std::pow(10, 6 / 20.0));
    for (std::size_t i = 960; i < dry.left.size(); ++i)
        REQUIRE_THAT(dry.left[i], WithinAbs(gain * burst.left[i], 1e-5));
}

TEST_CASE("If the level rises, a fade that reverberates in another sound's room gets no louder") {
    const double former = GENERATE(5.3, -22.8), next = GENERATE(-41.0, -55.0);
    const std::size_t blockSize = GENERATE(32, 480);
    PreparedStage stage;
    const Stereo nothing{std::vector<float>(9600), std::vector<float>(9600)};
    processed(stage, sine(4800), blockSize, valuesWith(former)); // room is off
    constexpr std::size_t fadeSamples = 240;
    const float before = stage.changeSound(inRoom(next), fadeSamples / rateHz);
    auto fading = sine(fadeSamples);
    for (std::size_t i = 0; i < fadeSamples; ++i)
        fading[i] *= before * (1 - static_cast<float>(i) / fadeSamples);
    processed(stage, Stereo{fading, fading}, fadeSamples, inRoom(next));
    const auto tail = processed(stage, nothing, blockSize, inRoom(former));
    const auto most = static_cast<float>(std::pow(10, former / 20));
    CHECK(std::ranges::all_of(tail.left, [&](float x) { return std::abs(x) <= most; }));
    CHECK(std::ranges::any_of(tail.left, [&](float x) { return std::abs(x) > 1e-4f * most; }));
}

TEST_CASE("The level is the same for all block sizes if a room falls silent and is used again") {
    const auto room = [](double levelDecibels) {
        auto values = inRoom(levelDecibels);
        values.set(ParameterId::roomDecay, 0.4);
        return values;
    };
    constexpr std::size_t blockSize = 4096;
    const auto begun = [&](PreparedStage& stage) {
        processed(stage, Stereo{sine(blockSize), sine(blockSize, 700)}, 64, room(5));
        stage.changeSound(room(-30));
    };
    PreparedStage measured;
    begun(measured);
    std::size_t silentAfter = 0; // the time of the next input
    const Stereo cell{std::vector<float>(64), std::vector<float>(64)};
    for (; !measured.silent(); silentAfter += 64)
        processed(measured, cell, 64, room(-30));
    const auto blocks = silentAfter / blockSize + 2;
    Stereo input{std::vector<float>(blocks * blockSize), std::vector<float>(blocks * blockSize)};
    const auto burst = sine(blocks * blockSize - silentAfter - 64);
    std::ranges::copy(burst, input.left.end() - std::ssize(burst));
    std::ranges::copy(burst, input.right.end() - std::ssize(burst));

    PreparedStage fine, coarse;
    Stereo expected, found;
    for (auto* stage : {&fine, &coarse}) {
        begun(*stage);
        auto& heard = stage == &fine ? expected : found;
        const auto size = stage == &fine ? std::size_t{64} : blockSize;
        processed(*stage, input, size, room(-30));
        const Stereo nothing{std::vector<float>(9600), std::vector<float>(9600)};
        heard = processed(*stage, nothing, size, room(-10));
    }
    CHECK(expected == found);
}

TEST_CASE("The level stays correct, however often levels and sounds change during reverb") {
    PreparedStage stage;
    const auto loud = inRoom(24), soft = inRoom(-60);
    const Stereo ones{std::vector<float>(1000, 1.0f), std::vector<float>(1000, 1.0f)};
    // Each change raises the level before the room by 84 dB.
    for (int time = 0; time < 50; ++time) {
        stage.changeSound(loud);
        const auto louder = processed(stage, ones, 100, loud);
        const bool isBounded =
            std::ranges::all_of(louder.left, [](float x) { return std::abs(x) < 1e4f; });
        REQUIRE(isBounded);
        processed(stage, ones, 100, soft);
    }
    auto dry = valuesWith(-7);
    processed(stage, ones, 100, dry);
    const Stereo one{{1.0f}, {1.0f}};
    CHECK_THAT(processed(stage, one, 1, dry).left.front(),
               WithinRel(std::pow(10, -7 / 20.0), 1e-5));
}

TEST_CASE("Once old reverb has decayed, the level applies to the reverb again") {
    const double former = GENERATE(-20.0, 5.0), next = GENERATE(-40.0, 0.0);
    PreparedStage stage, fresh;
    const Stereo burst{sine(4800), sine(4800, 700)};
    const Stereo silence{std::vector<float>(48000), std::vector<float>(48000)};
    processed(stage, burst, 480, inRoom(former));
    stage.changeSound(inRoom(next));
    processed(stage, burst, 480, inRoom(next));
    for (int seconds = 0; seconds < 60 && !stage.silent(); ++seconds)
        processed(stage, silence, 480, inRoom(next));
    REQUIRE(stage.silent());
    processed(fresh, silence, 480, inRoom(next));

    // Raises the level and lowers it again during reverb.
    for (const double level : {next, next + 18, next}) {
        const auto heard = processed(stage, burst, 480, inRoom(level)),
                   wanted = processed(fresh, burst, 480, inRoom(level));
        for (std::size_t i = 0; i < heard.left.size(); ++i)
            REQUIRE_THAT(heard.left[i], WithinAbs(wanted.left[i], 1e-5));
    }
}

TEST_CASE("A change before the first block or in a silent room gives the output of a new stage") {
    PreparedStage fresh, changed, former;
    const auto input = sine(1000);
    const auto expected = processed(fresh, input, 100, valuesWith(-7.3));
    CHECK(changed.changeSound(valuesWith(5)) == 1);
    CHECK(processed(changed, input, 100, valuesWith(-7.3)) == expected);
    processed(former, input, 100, valuesWith(5.1));
    former.changeSound(valuesWith(-7.3));
    CHECK(processed(former, input, 100, valuesWith(-7.3)) == expected);
}
