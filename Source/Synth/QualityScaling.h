// How many modes each ringing object may mix (Raghuvanshi & Lin 2006, quality scaling): a pure
// function, counted in modes and never in measured time, so that a render repeats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace idiophone {

struct ModeDemand {
    double amplitude = 0;   ///< summed amplitude of the object's modes; decides its rank
    std::int32_t modes = 0; ///< as many as it could mix
};

/// What rank r of n objects is entitled to, see below; r < n.
double modeEntitlement(std::size_t rank, std::size_t objects, double budget, double slope) noexcept;

/// Divides `budget` Q among n objects. They are ranked by amplitude, loudest first, ties in the
/// order given; rank r = 0, 1, … is entitled to max(0, a − S·r·Q/n²) with a such that the
/// entitlements sum to Q. S = 0 is equal shares; S = ∞ entitles the first to everything. What an
/// object does not need goes on to the next in rank.
/// Entitlements are rounded down, and the whole modes that this leaves of ⌊Q⌋ go to the loudest,
/// one each: so an object that joins the ranks moves the shares of few others. `ranking` is scratch
/// of n, and holds the ranks' objects on return.
void shareModeBudget(std::span<const ModeDemand> demands,
                     double budget,
                     double slope,
                     std::span<std::int32_t> ranking,
                     std::span<std::int32_t> shares) noexcept;

} // namespace idiophone
