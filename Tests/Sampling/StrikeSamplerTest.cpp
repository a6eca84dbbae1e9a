#include "Sampling/StrikeSampler.h"
#include "Sampling/SampledBar.h"

#include <algorithm>
#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;

namespace {

SampledStrike keyStrike(int velocity, std::uint64_t turn = 0) {
    return {.by = SampledStrike::KeyStrike{.key = 60, .velocity = velocity}, .turn = turn};
}

StereoSamples struck(const SampledInstrument& bar, const SampledStrike& strike) {
    return sampleStrike(bar, strike, -60, 60).value();
}

} // namespace

TEST_CASE("A sample repeats bit for bit, and other turns differ") {
    const auto bar = sampledBar();
    const auto once = struck(bar, keyStrike(100));
    CHECK(once.peak() > 0);
    CHECK((struck(bar, keyStrike(100)).left == once.left));
    CHECK_FALSE((struck(bar, keyStrike(100, 1)).left == once.left));
}

TEST_CASE("Strikes keep their loudness relative to each other, above full scale too") {
    auto bar = sampledBar();
    bar.values.set(ParameterId::strikeSpread, 0);
    const auto soft = struck(bar, keyStrike(127)).peak();
    bar.values.set(ParameterId::level, bar.values[ParameterId::level] + 24);
    const auto loud = struck(bar, keyStrike(127)).peak();
    CHECK(std::abs(20 * std::log10(loud / soft) - 24) < 0.01f);
}

TEST_CASE("A cut tail ends at its level and fades to zero") {
    auto sound = struck(sampledBar({440}), keyStrike(100));
    const auto whole = sound;
    const auto threshold = 0.001f * sound.peak();
    sound.cutTail(-60, 48000);
    REQUIRE(sound.left.size() > 480);
    REQUIRE(sound.left.size() < whole.left.size());
    const auto end = sound.left.size() - 480;
    CHECK(std::max(std::abs(whole.left[end - 1]), std::abs(whole.right[end - 1])) >= threshold);
    for (std::size_t i = end; i < whole.left.size(); ++i)
        REQUIRE(std::max(std::abs(whole.left[i]), std::abs(whole.right[i])) < threshold);
    CHECK((std::equal(sound.left.begin(), sound.left.begin() + static_cast<std::ptrdiff_t>(end),
                      whole.left.begin())));
    CHECK(std::abs(sound.left.back()) < 1e-9f);
}

TEST_CASE("A place is struck on the surface, as loud as the velocity says") {
    const auto bar = sampledBar();
    const auto strike = [](int velocity) {
        SurfaceStrike surface;
        surface.velocity = velocity;
        surface.point.weights = {1, 0, 0};
        return SampledStrike{.by = surface};
    };
    CHECK(strike(30).velocity() == 30);
    const auto soft = struck(bar, strike(30)).peak(), hard = struck(bar, strike(120)).peak();
    CHECK(soft > 0);
    CHECK(hard > 2 * soft);
}

TEST_CASE("A key sounds in the instrument's tuning") {
    auto bar = sampledBar({440, 1210}, KeyMapKind::scaled);
    const auto equal = struck(bar, keyStrike(100));
    bar.tuning.semitonesFromEqual[60] = 1;
    CHECK_FALSE((struck(bar, keyStrike(100)).left == equal.left));
    bar.tuning.unmapped.set(60);
    CHECK(struck(bar, keyStrike(100)).peak() == 0);
}

TEST_CASE("Sampling a strike can be cancelled") {
    const std::atomic<bool> cancelled{true};
    const auto sound = sampleStrike(sampledBar(), keyStrike(100), -60, 60,
                                    {.progress = {}, .cancelled = &cancelled});
    REQUIRE(!sound);
    CHECK(isCancellation(sound.error()));
}
