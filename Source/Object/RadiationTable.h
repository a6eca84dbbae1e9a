// SPDX-License-Identifier: Apache-2.0
// The pressure that each mode radiates in a few directions, over its frequency.
// Analysis/Radiation.h fills the table; the audio thread looks up weights.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace idiophone {

/// Dimensions: D directions, K frequency ratios, M modes. Part of an object; empty if it was not
/// computed. Let the modal velocity of a mode be the real part of s. At the distance R from the
/// centre of mass, the mode radiates the pressure Re(w s)/R, delayed by the travel time of sound.
///
/// Frequency times size is constant for uniformly scaled copies of a material. The ratio to look up
/// is therefore (natural frequency now / reference) · (size now / reference), 1 for such copies.
struct RadiationTable {
    std::vector<std::array<float, 3>>
        directions;                      ///< [D] unit, object to listener; left, right, more
    std::vector<double> frequencyRatios; ///< [K] > 0, ascending
    std::vector<std::complex<float>>
        weights; ///< [D,K,M] w in Pa·m per unit modal velocity, m/s · √kg

    bool empty() const noexcept { return weights.empty(); }

    /// Writes the weights of the modes from `firstMode` on, as many as `modeWeights` has elements.
    /// Interpolates magnitude and phase separately, so that no
    /// weight vanishes between two ratios. Below the table, weights fall with the square of the
    /// ratio, as for bodies without net flow. Above it, the weights of the last ratio apply. For a
    /// ratio that is not a positive number, those of the first ratio apply. Expects a table that is
    /// not empty and `direction` < D. Audio thread: does not allocate or lock.
    void weightsAt(std::size_t direction,
                   double frequencyRatio,
                   std::span<std::complex<float>> modeWeights,
                   std::size_t firstMode = 0) const noexcept;

    /// Returns the direction nearest to a listener's, given in mesh coordinates with any length.
    /// Returns nothing if the table only has left and right of the front. Audio thread.
    std::optional<std::size_t>
    directionTowards(const std::array<float, 3>& listener) const noexcept;

    bool operator==(const RadiationTable&) const = default;
};

/// Interpolates two complex numbers: magnitude linear in `share` (0 to 1), phase along the shorter
/// way.
std::complex<float>
phasorBetween(std::complex<float> from, std::complex<float> to, float share) noexcept;

/// Returns the first error of a table for that number of modes, or an empty text. An empty table is
/// valid.
std::string faultOf(const RadiationTable& table, std::size_t modeCount);

} // namespace idiophone
