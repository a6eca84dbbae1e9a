#include "Synth/QualityScaling.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <limits>
#include <numeric>
#include <vector>

using namespace idiophone;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Shares = std::vector<std::int32_t>;

Shares sharesOf(const std::vector<ModeDemand>& demands, double budget, double slope) {
    BudgetShares division(demands.size());
    division.divide(demands, budget, slope);
    return {division.shares().begin(), division.shares().end()};
}

} // namespace

// Three objects, Q = 40, n² = 9. By loudness: the middle, the last, the first.
const std::vector<ModeDemand> hungry{{0.1, 100}, {3, 100}, {2, 100}};

TEST_CASE("S = 0 gives equal shares") {
    CHECK(sharesOf(hungry, 39, 0) == Shares{13, 13, 13});
}

TEST_CASE("S = 1 lowers the share by Q/n^2 from rank to rank") {
    // Fall 40/9 and 3a − 40/9 (0 + 1 + 2) = 40, so a = 160/9: 17.8, 13.3, 8.9. Rounded down 17, 13,
    // 8; the remaining two go to the loudest.
    CHECK(sharesOf(hungry, 40, 1) == Shares{8, 18, 14});
}

TEST_CASE("A steep slope leaves nothing for the last object") {
    // S = 3: fall 40/3; all three would need a = 80/3: 26.7, 13.3, 0. S = 4: fall 160/9; the first
    // two share 2a − 160/9 = 40, a = 28.9: 28.9, 11.1, 0. Rounded down; one remains of each.
    CHECK(sharesOf(hungry, 40, 3) == Shares{0, 27, 13});
    CHECK(sharesOf(hungry, 40, 4) == Shares{0, 29, 11});
}

TEST_CASE("S = infinity is greedy") {
    CHECK(sharesOf(hungry, 12, infinity) == Shares{0, 12, 0});
    CHECK(sharesOf({{0.1, 100}, {3, 7}, {2, 4}}, 12, infinity) == Shares{1, 7, 4});
}

TEST_CASE("The unneeded part of a share goes to the next rank") {
    // S = 1 entitles ranks to 5, 4, 3. The first needs 2, so 3 pass to the second: 7. It needs 6,
    // so 1 passes to the third: 4.
    CHECK(sharesOf({{0.1, 100}, {3, 2}, {2, 6}}, 12, 1) == Shares{4, 2, 6});
}

TEST_CASE("Equal amplitudes rank in the order of the slots") {
    CHECK(sharesOf({{1, 9}, {1, 9}}, 9, infinity) == Shares{9, 0});
}

TEST_CASE("A budget that suffices gives each object its demand") {
    // By rank, the loudest is entitled to 5 modes only.
    CHECK(sharesOf({{1, 1}, {3, 10}, {2, 1}}, 12, 1) == Shares{1, 10, 1});
    BudgetShares division(2);
    CHECK(division.sufficient());
    const std::vector<ModeDemand> demands{{1, 5}, {2, 4}};
    division.divide(demands, 9, 1);
    CHECK(division.sufficient());
    division.divide(demands, 8.9, 1);
    CHECK_FALSE(division.sufficient());
    division.reset();
    CHECK(division.sufficient());
}

TEST_CASE("Modes that no lower rank needs go to the loudest objects without their demand") {
    // S = 1 gives the ranks 6, 4 and 2 modes, of which the last two leave 3 and 1.
    CHECK(sharesOf({{1, 1}, {3, 11}, {2, 1}}, 12, 1) == Shares{1, 10, 1});
}

TEST_CASE("As long as the budget lasts an object gets at least six modes or its demand") {
    const std::vector<ModeDemand> five{{1, 9}, {5, 9}, {3, 2}, {4, 9}, {2, 9}};
    CHECK(sharesOf(five, 3, 0) == Shares{0, 3, 0, 0, 0});
    CHECK(sharesOf(five, 15, 0) == Shares{0, 6, 2, 6, 1});
    CHECK(sharesOf(five, 15, 1) == Shares{0, 6, 2, 6, 1});
}

TEST_CASE("An object that joins as the loudest changes one share or two") {
    std::vector<ModeDemand> crowd;
    for (int k = 0; k < 100; ++k)
        crowd.push_back({100.0 - k, 9});
    const auto before = sharesOf(crowd, 50, 0);
    crowd.push_back({1000, 9});
    const auto after = sharesOf(crowd, 50, 0);
    int moved = 0;
    for (std::size_t k = 0; k < before.size(); ++k)
        moved += before[k] != after[k];
    CHECK(after.back() == 6);
    CHECK(moved <= 2);
}

TEST_CASE("A division does not depend on the last one") {
    const std::vector<ModeDemand> quiet{{0.01, 9}, {0.03, 9}, {0.02, 9}, {3, 2}};
    BudgetShares division(quiet.size());
    division.divide(hungry, 12, infinity);
    division.divide(quiet, 12, infinity);
    CHECK(Shares(division.shares().begin(), division.shares().end()) == Shares{0, 9, 1, 2});
}

TEST_CASE("An allowance is what the first quieter object with a share had available") {
    BudgetShares division(3);
    division.divide(hungry, 12, 3); // shares 8, 4 and 0 for amplitudes 3, 2 and 0.1
    CHECK(division.allowance(100) == 8);
    CHECK(division.allowance(2.5) == 4);
    CHECK(division.allowance(2) == 0);
    CHECK(division.allowance(0.5) == 0);
    division.dropUpTo(2);
    CHECK(division.allowance(2.5) == 0);
    CHECK(division.allowance(100) == 8);
}

TEST_CASE("Shares use the whole budget and never exceed it") {
    for (const double slope : {0.0, 0.3, 1.0, 2.5, 20.0, infinity})
        for (const double budget : {0.0, 1.0, 7.0, 100.5, 4096.0, infinity})
            for (std::size_t n = 1; n < 40; ++n) {
                std::vector<ModeDemand> demands;
                for (std::size_t k = 0; k < n; ++k)
                    demands.push_back({static_cast<double>((k * 7) % 11), 200'000'000});
                const Shares shares = sharesOf(demands, budget, slope);
                const auto total = std::accumulate(shares.begin(), shares.end(), std::int64_t{0});
                if (budget < 1e6)
                    CHECK(total == static_cast<std::int64_t>(budget));
                CHECK(*std::min_element(shares.begin(), shares.end()) >= 0);
            }
}
