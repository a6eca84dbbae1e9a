// SPDX-License-Identifier: Apache-2.0
#include "Synth/QualityScaling.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace idiophone {

namespace {

// This value is above any budget and keeps an infinite Q within integers.
constexpr double largestBudget = 1e9;

// This slope is finite, and greedy for any number of objects.
constexpr double steepestSlope = 1e12;

/// Entitlements fall on a line: `top` for the first rank, `fall` less from each rank to the next.
struct Entitlement {
    double top = 0;
    double fall = 0;

    double at(std::size_t rank) const noexcept {
        return std::max(0.0, top - fall * static_cast<double>(rank));
    }
    /// Rounds down; values within rounding error of a whole number count as whole.
    double wholeAt(std::size_t rank) const noexcept {
        return std::floor(at(rank) * (1 + 1e-9) + 1e-9);
    }
};

Entitlement entitlement(std::size_t objects, double budget, double slope) noexcept {
    const auto n = static_cast<double>(objects);
    const double fall = std::min(slope, steepestSlope) * budget / (n * n);
    // If the first k have an entitlement, k a − fall k(k−1)/2 = Q. The k-th must stay above 0.
    double entitled = n;
    while (entitled > 1 && budget / entitled <= fall * (entitled - 1) / 2)
        entitled -= 1;
    return {budget / entitled + fall * (entitled - 1) / 2, fall};
}

/// Sorts by amplitude in single precision; of equal objects the first is the largest.
std::uint64_t sortingKey(double amplitude, std::uint32_t object) noexcept {
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(amplitude));
    return std::uint64_t{bits} << 32 | ~object;
}

} // namespace

std::int64_t wholeBudget(double budget) noexcept {
    return static_cast<std::int64_t>(std::clamp(budget, 0.0, largestBudget));
}

double
modeEntitlement(std::size_t rank, std::size_t objects, double budget, double slope) noexcept {
    return entitlement(objects, static_cast<double>(wholeBudget(budget)), slope).at(rank);
}

BudgetShares::BudgetShares(std::size_t maximumObjects) {
    shareOf.reserve(maximumObjects);
    unranked.reserve(maximumObjects);
    ranks.reserve(maximumObjects);
}

void BudgetShares::divide(std::span<const ModeDemand> demands,
                          double budget,
                          double slope) noexcept {
    const std::int64_t whole = wholeBudget(budget);
    std::int64_t demanded = 0;
    for (const ModeDemand& demand : demands)
        demanded += demand.modes;
    suffices = demanded <= whole;
    shareOf.assign(demands.size(), 0);
    if (!suffices)
        return shareByRank(demands, static_cast<double>(whole), slope);
    ranks.clear();
    std::ranges::transform(demands, shareOf.begin(), &ModeDemand::modes);
}

// Only objects with a share are sorted. The quiet ones, which got none last time, are left out
// until the budget lasts beyond the others.
void BudgetShares::shareByRank(std::span<const ModeDemand> demands,
                               double whole,
                               double slope) noexcept {
    unranked.resize(demands.size());
    for (std::size_t object = 0; object < demands.size(); ++object)
        unranked[object] =
            sortingKey(demands[object].amplitude, static_cast<std::uint32_t>(object));
    const std::uint64_t quiet = ranks.empty() ? 0 : sortingKey(ranks.back().amplitude / 2, 0);
    auto heap = std::partition(unranked.begin(), unranked.end(),
                               [quiet](std::uint64_t key) { return key <= quiet; });
    std::make_heap(heap, unranked.end());
    ranks.clear();

    const Entitlement line = entitlement(demands.size(), whole, slope);
    double spare = whole;
    for (std::size_t rank = 0; rank < demands.size() && line.wholeAt(rank) > 0; ++rank)
        spare -= line.wholeAt(rank);
    auto left = static_cast<std::int32_t>(whole);
    std::int32_t unused = 0;
    while (left > 0 && !unranked.empty()) {
        if (heap == unranked.end()) {
            heap = unranked.begin();
            std::make_heap(heap, unranked.end());
        }
        std::pop_heap(heap, unranked.end());
        const std::size_t object = ~static_cast<std::uint32_t>(unranked.back());
        unranked.pop_back();
        const double more = std::clamp(spare, 0.0, 1.0);
        spare -= more;
        const std::int32_t entitled =
            static_cast<std::int32_t>(line.wholeAt(ranks.size()) + more) + unused;
        const std::int32_t available = std::min(std::max(entitled, minimumModes), left);
        const std::int32_t share = std::min(available, demands[object].modes);
        shareOf[object] = share;
        ranks.push_back({object, demands[object].amplitude, available});
        unused = std::max(entitled - share, 0);
        left -= share;
    }
    for (const Rank& rank : ranks) {
        const std::int32_t more = std::min(left, demands[rank.object].modes - shareOf[rank.object]);
        shareOf[rank.object] += more;
        left -= more;
    }
}

void BudgetShares::reset() noexcept {
    suffices = true;
    shareOf.clear();
    ranks.clear();
}

void BudgetShares::dropUpTo(double amplitude) noexcept {
    while (!ranks.empty() && ranks.back().amplitude <= amplitude)
        ranks.pop_back();
}

std::int32_t BudgetShares::allowance(double amplitude) const noexcept {
    const auto quieter = std::ranges::partition_point(
        ranks, [&](const Rank& rank) { return rank.amplitude >= amplitude; });
    return quieter == ranks.end() ? 0 : quieter->available;
}

} // namespace idiophone
