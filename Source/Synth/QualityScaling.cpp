#include "Synth/QualityScaling.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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

double wholeBudget(double budget) noexcept {
    return std::floor(std::clamp(budget, 0.0, largestBudget));
}

} // namespace

double
modeEntitlement(std::size_t rank, std::size_t objects, double budget, double slope) noexcept {
    return entitlement(objects, wholeBudget(budget), slope).at(rank);
}

void shareModeBudget(std::span<const ModeDemand> demands,
                     double budget,
                     double slope,
                     std::span<std::int32_t> ranking,
                     std::span<std::int32_t> shares) noexcept {
    if (demands.empty())
        return;
    const auto ranks = ranking.first(demands.size());
    std::iota(ranks.begin(), ranks.end(), 0);
    std::sort(ranks.begin(), ranks.end(), [&](std::int32_t a, std::int32_t b) {
        const double left = demands[static_cast<std::size_t>(a)].amplitude;
        const double right = demands[static_cast<std::size_t>(b)].amplitude;
        return left != right ? left > right : a < b;
    });

    const double whole = wholeBudget(budget);
    const Entitlement line = entitlement(demands.size(), whole, slope);
    double left = whole;
    for (std::size_t rank = 0; rank < ranks.size(); ++rank)
        left -= line.wholeAt(rank);
    std::int32_t unused = 0;
    for (std::size_t rank = 0; rank < ranks.size(); ++rank) {
        const double more = std::clamp(left, 0.0, 1.0);
        left -= more;
        const std::int32_t available =
            static_cast<std::int32_t>(line.wholeAt(rank) + more) + unused;
        const auto object = static_cast<std::size_t>(ranks[rank]);
        shares[object] = std::min(available, demands[object].modes);
        unused = available - shares[object];
    }
}

} // namespace idiophone
