#include "Synth/SharedSurfaceProfile.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

TEST_CASE("A profile is shared only for the same surface and rate") {
    Surface slate;
    slate.resonFrequencyHz = 900;
    const auto first = sharedSurfaceProfile(slate, 48000);
    CHECK(first->surface() == slate);
    CHECK(first->sampleRateHz() == 48000);
    CHECK(sharedSurfaceProfile(slate, 48000) == first);
    CHECK(sharedSurfaceProfile(slate, 44100) != first);
    CHECK(sharedSurfaceProfile({}, 48000) != first);
    CHECK(sharedSurfaceProfile(slate, 48000) == first);
}

TEST_CASE("A profile dropped from the cache is made again identically") {
    const auto first = sharedSurfaceProfile({}, 48000);
    for (int rateHz = 20000; rateHz < 20010; ++rateHz)
        sharedSurfaceProfile({}, rateHz);
    const auto again = sharedSurfaceProfile({}, 48000);
    CHECK(again != first);
    for (double position = 0; position < 1000; position += 0.3)
        REQUIRE(again->at(position) == first->at(position));
}
