// Tests the threads that share work.
#include "Scene/WorkTeam.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cfenv>
#include <stdexcept>

using namespace idiophone;

TEST_CASE("A team calls every item of a loop once") {
    WorkTeam team(GENERATE(1u, 2u, 5u));
    for (std::size_t count = 0; count < 300; ++count) {
        std::vector<std::atomic<int>> calls(count);
        team.runAll(count, [&](std::size_t item, std::size_t) { ++calls[item]; });
        for (const auto& call : calls)
            REQUIRE(call == 1);
    }
}

TEST_CASE("A team runs both tasks, one of which may share a loop") {
    WorkTeam team(GENERATE(1u, 2u, 5u));
    for (int round = 0; round < 200; ++round) {
        int other = 0;
        std::atomic<int> items{0};
        team.runBoth([&] { ++other; },
                     [&] { team.runAll(20, [&](std::size_t, std::size_t) { ++items; }); });
        REQUIRE(other == 1);
        REQUIRE(items == 20);
    }
}

TEST_CASE("The other task is complete if the owner's throws") {
    WorkTeam team(GENERATE(1u, 2u));
    for (int round = 0; round < 50; ++round) {
        int other = 0;
        CHECK_THROWS_AS(team.runBoth([&] { ++other; }, [] { throw std::runtime_error("no"); }),
                        std::runtime_error);
        REQUIRE(other == 1);
    }
}

TEST_CASE("All threads of a team work in the floating-point mode of its owner") {
    WorkTeam team(4);
    for (const int mode : {FE_UPWARD, FE_TONEAREST}) {
        std::fesetround(mode);
        int other = -1;
        std::atomic<int> differing{0};
        team.runBoth([&] { other = std::fegetround(); },
                     [&] {
                         team.runAll(1000, [&](std::size_t, std::size_t) {
                             differing += std::fegetround() != mode ? 1 : 0;
                         });
                     });
        CHECK(other == mode);
        CHECK(differing == 0);
    }
}
