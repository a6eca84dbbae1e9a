#include "Plugin/RemainingTime.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace std::chrono_literals;

TEST_CASE("The remaining time follows from the time passed and the part done") {
    const RemainingTime::Time start(1h);
    RemainingTime time;
    CHECK_FALSE(time.seconds(start));
    time.start(start);
    time.report(0.5, start + 500ms); // too early to tell
    time.report(0.01, start + 2s);
    CHECK_FALSE(time.seconds(start + 2s));
    time.report(0.25, start + 2s);
    CHECK(time.seconds(start + 2s) == 6);
    CHECK(time.seconds(start + 5s) == 3); // falls by itself
    CHECK(time.seconds(start + 7900ms) == 1);
    CHECK_FALSE(time.seconds(start + 8s)); // longer than estimated
    time.report(0.5, start + 10s);
    CHECK(time.seconds(start + 10s) == 10);
    time.report(0.5, start + 23s); // slower than expected
    CHECK(time.seconds(start + 23s) == 25);
    time.start(start);
    CHECK_FALSE(time.seconds(start));
}
