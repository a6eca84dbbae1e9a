#include "Instrument/PendingStrikes.h"

#include <catch2/catch_test_macros.hpp>
#include <random>
#include <tuple>

using namespace idiophone;

TEST_CASE("Strikes come out in order of time, and in order of arrival at equal times") {
    PendingStrikes pending(100);
    std::mt19937 random(1);
    for (std::size_t i = 0; i < 100; ++i)
        pending.add({.cell = static_cast<std::int64_t>(random() % 5),
                     .sampleInCell = static_cast<double>(random() % 8) / 2,
                     .slot = i,
                     .strike = {}});
    CHECK(pending.room() == 0);
    std::tuple<std::int64_t, double, std::size_t> last{-1, 0, 0};
    for (std::size_t i = 0; i < 100; ++i) {
        const auto* next = pending.next();
        REQUIRE(next != nullptr);
        const std::tuple now{next->cell, next->sampleInCell, next->slot};
        CHECK(last < now);
        last = now;
        pending.pop();
    }
    CHECK(pending.empty());
    CHECK(pending.next() == nullptr);
    CHECK(pending.room() == 100);
}
