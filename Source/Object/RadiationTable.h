// The pressure that each mode radiates in a few directions, as its frequency moves. Analysis fills
// the table (Analysis/Radiation.h), the audio thread looks weights up in it.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace idiophone {

/// D directions, K ratios, M modes. Part of an object, and empty where nobody computed it. A mode
/// whose modal velocity is the real part of s radiates the pressure Re(w s)/R at the distance R
/// from the centre of mass, as much later as sound takes there.
///
/// A uniformly scaled copy of the same material has the same frequency times size. So the ratio to
/// look up is (natural frequency now / reference) · (size now / reference), 1 for such copies.
struct RadiationTable {
    std::vector<std::array<float, 3>>
        directions;                      ///< [D] unit, object to listener; left, right, more
    std::vector<double> frequencyRatios; ///< [K] > 0, ascending
    std::vector<std::complex<float>>
        weights; ///< [D,K,M] w in Pa·m per unit modal velocity, m/s · √kg

    bool empty() const noexcept { return weights.empty(); }

    /// Writes the weights of all modes. Between two ratios, size and phase are interpolated each,
    /// so that no weight vanishes between two that do not. Below the table weights fall as the
    /// square of the ratio, as those of bodies without net flow do; above it, and for a ratio that
    /// is no positive number, they are those of its end. The table is not empty, `direction` < D
    /// and `modeWeights` has M places. Audio thread: neither allocates nor locks.
    void weightsAt(std::size_t direction,
                   double frequencyRatio,
                   std::span<std::complex<float>> modeWeights) const noexcept;

    /// The same for as many modes, from `firstMode` on, as there are places.
    void weightsAt(std::size_t direction,
                   double frequencyRatio,
                   std::size_t firstMode,
                   std::span<std::complex<float>> modeWeights) const noexcept;

    /// The direction nearest to one (of any length) in which a listener is, in the coordinates of
    /// the mesh; none where the table has but two, left and right of the front. Audio thread.
    std::optional<std::size_t>
    directionTowards(const std::array<float, 3>& listener) const noexcept;

    bool operator==(const RadiationTable&) const = default;
};

/// Between two complex numbers: the size is linear in `share` (0 to 1), the phase turns the short
/// way.
std::complex<float>
phasorBetween(std::complex<float> from, std::complex<float> to, float share) noexcept;

/// The first thing wrong with a table for that many modes, or empty. An empty table is sound.
std::string faultOf(const RadiationTable& table, std::size_t modeCount);

} // namespace idiophone
