// Tests the threads that share work.
#include "Object/WorkTeam.h"

#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cfenv>
#include <stdexcept>
#include <vector>

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

TEST_CASE("The owner gets the exception of an item, and no further items start") {
    WorkTeam team(GENERATE(1u, 2u, 5u));
    for (int round = 0; round < 50; ++round) {
        std::atomic<std::size_t> calls{0};
        CHECK_THROWS_AS(team.runAll(1'000'000,
                                    [&](std::size_t item, std::size_t) {
                                        ++calls;
                                        if (item == 100)
                                            throw std::runtime_error("no");
                                    }),
                        std::runtime_error);
        CHECK(calls < 1'000'000);
        std::atomic<int> after{0};
        team.runAll(100, [&](std::size_t, std::size_t) { ++after; });
        CHECK(after == 100);
    }
}

TEST_CASE("Threads share all rows, and one thread takes them if there is no team") {
    WorkTeam team(GENERATE(1u, 2u, 5u));
    for (WorkTeam* sharing : {&team, static_cast<WorkTeam*>(nullptr)})
        for (const std::ptrdiff_t rows : {0, 1, 7, 8, 9, 40, 41, 1000}) {
            std::vector<std::atomic<int>> calls(rows);
            shareRows(sharing, rows, [&](std::ptrdiff_t first, std::ptrdiff_t count) {
                for (std::ptrdiff_t row = first; row < first + count; ++row)
                    ++calls[row];
            });
            for (const auto& call : calls)
                CHECK(call == 1);
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
