// Shares the mode budget among ringing objects (Raghuvanshi & Lin 2006, quality scaling). A pure
// function that counts modes, never measured time, so that renders repeat.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace idiophone {

struct ModeDemand {
    double amplitude = 0;   ///< summed amplitude of the object's modes, which decides its rank
    std::int32_t modes = 0; ///< number of modes that it could mix
};

/// Returns the entitlement of rank r < n of n objects, in modes; see shareModeBudget.
double modeEntitlement(std::size_t rank, std::size_t objects, double budget, double slope) noexcept;

/// Divides `budget` Q among n objects. They are ranked by amplitude, loudest first; equal objects
/// keep their order. Rank r = 0, 1, … is entitled to max(0, a − S·r·Q/n²), with a such that the
/// entitlements sum to Q. S = 0 gives equal shares; S = ∞ entitles the first to everything. The
/// unneeded part of a share goes to the next rank.
///
/// Entitlements are rounded down. The whole modes that remain of ⌊Q⌋ go to the loudest, one each,
/// so that a new object changes the shares of few others. `ranking` is scratch of size n and
/// returns the objects by rank.
void shareModeBudget(std::span<const ModeDemand> demands,
                     double budget,
                     double slope,
                     std::span<std::int32_t> ranking,
                     std::span<std::int32_t> shares) noexcept;

} // namespace idiophone
