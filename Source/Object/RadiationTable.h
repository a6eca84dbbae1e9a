// How loudly each mode is heard from afar in a few directions, as its frequency moves. Analysis
// fills the table, the audio thread looks weights up in it; where the figures come from is
// Analysis/Radiation's business.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace idiophone {

/// D directions, K ratios, M modes; a part of an object, and empty where nobody computed it.
///
/// What counts is frequency times size over the speed of sound, so the ratio to look up is (natural
/// frequency now / reference) · (size now / reference), which a uniformly scaled copy of the same
/// material leaves at 1. Weights scale like shapes, with 1/√mass.
struct RadiationTable {
    std::vector<std::array<float, 3>>
        directions;                      ///< [D] unit, object to listener; left, right, more
    std::vector<double> frequencyRatios; ///< [K] > 0, ascending
    std::vector<float> weights;          ///< [D,K,M] signed, in 1/√kg

    bool empty() const noexcept { return weights.empty(); }

    /// Writes the weights of all modes, linear in the logarithm of the ratio and held beyond the
    /// table's ends (also for a ratio that is no positive number). The table is not empty,
    /// `direction` < D and `modeWeights` has M places. Audio thread: neither allocates nor locks.
    void weightsAt(std::size_t direction,
                   double frequencyRatio,
                   std::span<float> modeWeights) const noexcept;

    /// The same for as many modes, from `firstMode` on, as there are places.
    void weightsAt(std::size_t direction,
                   double frequencyRatio,
                   std::size_t firstMode,
                   std::span<float> modeWeights) const noexcept;

    /// The direction nearest to one (of any length) in which a listener is, in the coordinates of
    /// the mesh; none where the table has but two, left and right of the front. Audio thread.
    std::optional<std::size_t>
    directionTowards(const std::array<float, 3>& listener) const noexcept;

    bool operator==(const RadiationTable&) const = default;
};

/// The first thing wrong with a table for that many modes, or empty. An empty table is sound.
std::string faultOf(const RadiationTable& table, std::size_t modeCount);

} // namespace idiophone
