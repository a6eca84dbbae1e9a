// SPDX-License-Identifier: Apache-2.0
// Shares the mode budget among ringing objects (Raghuvanshi & Lin 2006, quality scaling). It counts
// modes, never measured time, so that renders repeat.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace idiophone {

struct ModeDemand {
    double amplitude = 0;   ///< summed amplitude of the object's modes, which decides its rank
    std::int32_t modes = 0; ///< number of modes that it could mix
};

/// A sounding object mixes at least this many modes as long as the budget lasts. One mode of each
/// of six times as many objects would cost more and be further from the unscaled mix
/// (docs/decisions/0006).
inline constexpr std::int32_t minimumModes = 6;

/// Returns the entitlement of rank r < n of n objects, in modes; see BudgetShares.
double modeEntitlement(std::size_t rank, std::size_t objects, double budget, double slope) noexcept;

/// Returns the budget in whole modes, at most 1e9.
std::int64_t wholeBudget(double budget) noexcept;

/// The last division of the budget. Memory is reserved by the constructor; every other member is
/// for the audio thread.
class BudgetShares {
public:
    explicit BudgetShares(std::size_t maximumObjects);

    /// Divides `budget` Q among n objects. If it suffices, each object gets its demand. Otherwise
    /// they are ranked by amplitude, loudest first; equal objects keep their order. Rank r = 0, 1,
    /// … is entitled to max(0, a − S·r·Q/n²), with a such that the entitlements sum to Q. S = 0
    /// gives equal entitlements; S = ∞ entitles the first to everything. The unneeded part of an
    /// entitlement goes to the next rank, and what the last rank leaves goes to the loudest.
    ///
    /// Entitlements are rounded down. The whole modes that remain of ⌊Q⌋ go to the loudest, one
    /// each. As long as Q lasts, no share is cut to less than `minimumModes`.
    void divide(std::span<const ModeDemand> demands, double budget, double slope) noexcept;
    /// Returns to an unlimited budget.
    void reset() noexcept;

    /// Returns whether each object got its demand.
    bool sufficient() const noexcept { return suffices; }
    /// Returns the share of each object in modes, in the order of the demands.
    std::span<const std::int32_t> shares() const noexcept { return shareOf; }
    /// A rank with a share, of those whose shares are limited.
    struct Rank {
        std::size_t object = 0; ///< index of its demand
        double amplitude = 0;
        std::int32_t available = 0; ///< modes
    };
    std::span<const Rank> ranked() const noexcept { return ranks; } ///< loudest first
    /// Returns how many modes were available to the first object that is quieter than `amplitude`,
    /// or 0 if no quieter one has a share.
    std::int32_t allowance(double amplitude) const noexcept;
    /// Takes in that objects up to an amplitude have lost their shares.
    void dropUpTo(double amplitude) noexcept;

private:
    void shareByRank(std::span<const ModeDemand> demands, double whole, double slope) noexcept;

    bool suffices = true;
    std::vector<std::int32_t> shareOf;
    /// Sorting keys of the others; the end is a heap, the loudest first.
    std::vector<std::uint64_t> unranked;
    std::vector<Rank> ranks; ///< none if the budget suffices
};

} // namespace idiophone
