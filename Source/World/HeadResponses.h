// SPDX-License-Identifier: Apache-2.0
// A measured head: impulse responses of both ears for directions all around.
#pragma once

#include "Object/Result.h"

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// Measured responses in the directions of `HeadResponses`, resampled to a sample rate.
struct HeadMeasurement {
    double measuredRateHz = 0; ///< of the measurement, which limits the band to half of it
    double sampleRateHz = 0;
    std::size_t lengthSamples = 0;
    std::vector<float> responses; ///< [directions, ears, length]; ears: left, right
};

/// Immutable, so that any number of sources can share it.
class HeadResponses {
public:
    static constexpr double longestSeconds = 0.005;
    static constexpr int stepDegrees = 5; ///< step of azimuth and elevation
    static constexpr std::size_t directionCount =
        static_cast<std::size_t>(360 / stepDegrees) * (180 / stepDegrees + 1);

    /// Returns a unit vector along the head's axes: ahead, left, up.
    static Eigen::Vector3d direction(std::size_t index);

    /// Removes the delay that all responses share and fades them out at `longestSeconds`. Scales
    /// them to the loudness of the spherical head for noise from straight ahead. The error is a
    /// sentence without a file name.
    static Result<std::shared_ptr<const HeadResponses>> make(const HeadMeasurement& measured);

    /// Restores responses from the `allSamples` of another object. The error is as in `make`.
    static Result<std::shared_ptr<const HeadResponses>> of(std::vector<float> samples);
    std::span<const float> allSamples() const noexcept { return samples; }

    /// Returns the nearest direction to a vector of any length.
    std::size_t nearest(const Eigen::Vector3d& towards) const noexcept;
    /// Returns the response of the left (0) or right (1) ear.
    std::span<const float> response(std::size_t index, std::size_t ear) const noexcept {
        return {samples.data() + (2 * index + ear) * length, length};
    }
    std::size_t lengthSamples() const noexcept { return length; }

private:
    HeadResponses() = default;

    std::size_t length = 0;
    std::vector<float> samples; ///< [directions, ears, length]
};

} // namespace idiophone
