#include "Instrument/SharedSurfaceProfile.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

TEST_CASE("One profile is shared for one surface and rate, and no more than that") {
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

TEST_CASE("A profile that was crowded out is made again just as it was") {
    const auto first = sharedSurfaceProfile({}, 48000);
    for (int rateHz = 20000; rateHz < 20010; ++rateHz)
        sharedSurfaceProfile({}, rateHz);
    const auto again = sharedSurfaceProfile({}, 48000);
    CHECK(again != first);
    for (double position = 0; position < 1000; position += 0.3)
        REQUIRE(again->at(position) == first->at(position));
}
