#include "Analysis/RecordingRest.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

using namespace idiophone;
using Catch::Matchers::WithinAbs;

TEST_CASE("The rest of a recording is divided into contact, steady tones, noise and others") {
    // One second at 1 kHz of energy 1000. The rest has energy 100 in the first 20 ms and 49 later.
    const DecayRecording recording{.samples = std::vector<double>(1000, 1.0), .sampleRateHz = 1000};
    std::vector<double> rest(1000, 0.0);
    for (std::size_t n = 0; n < 20; ++n)
        rest[n] = std::sqrt(5.0);
    for (std::size_t n = 100; n < 149; ++n)
        rest[n] = 1;
    const std::vector<DampedSinusoid> hum{
        {.pole = {.frequencyHz = 50, .decayPerSecond = 0.05}, .amplitudes = {0.2}}};
    const auto shares = restOf(recording, rest, hum, 0, 0.01);
    CHECK_THAT(shares.contact, WithinAbs(0.0998, 1e-9)); // without the noise in it
    CHECK_THAT(shares.steadyTones, WithinAbs(0.02, 1e-9));
    CHECK_THAT(shares.noise, WithinAbs(0.01, 1e-9));
    CHECK_THAT(shares.others, WithinAbs(0.0392, 1e-9));
    CHECK_THAT(shares.modes, WithinAbs(0.831, 1e-9));
    CHECK(
        shares.sentence() ==
        "The modes hold 83.1 % of the sound. The rest: 10.0 % noise of the contact, 2.0 % hum and "
        "other steady tones (50 Hz), 1.0 % steady noise and rumble, 3.9 % the room and modes too "
        "faint to keep.");
}

TEST_CASE("A recording that its modes explain has no rest to report") {
    CHECK(RecordingRest{.modes = 1, .steadyHz = {}}.sentence() ==
          "The modes hold 100.0 % of the sound.");
}
