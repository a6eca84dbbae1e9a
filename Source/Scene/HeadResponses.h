// A measured head: what both of its ears hear from all around, as impulse responses.
#pragma once

#include "Object/Result.h"

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// As it was measured, in the directions of `HeadResponses`, brought to a sample rate.
struct HeadMeasurement {
    double measuredRateHz = 0; ///< at which it was: it has the band below half of it
    double sampleRateHz = 0;
    std::size_t lengthSamples = 0;
    std::vector<float> responses; ///< [directions, ears, length], ears left and right
};

/// Immutable, so that any number of sources share it.
class HeadResponses {
public:
    static constexpr double longestSeconds = 0.005;
    static constexpr int stepDegrees = 5; ///< of azimuth and elevation
    static constexpr std::size_t directionCount =
        static_cast<std::size_t>(360 / stepDegrees) * (180 / stepDegrees + 1);

    /// Unit, along the head's own axes: ahead, left, up.
    static Eigen::Vector3d direction(std::size_t index);

    /// Without the time that all responses have in common, faded out at `longestSeconds`, and as
    /// loud as the spherical head for noise from straight ahead. The error is a sentence without
    /// the name of a file.
    static Result<std::shared_ptr<const HeadResponses>> make(const HeadMeasurement& measured);

    /// What `allSamples` gave of others. The error is as before.
    static Result<std::shared_ptr<const HeadResponses>> of(std::vector<float> samples);
    std::span<const float> allSamples() const noexcept { return samples; }

    /// The direction nearest to one of any length.
    std::size_t nearest(const Eigen::Vector3d& towards) const noexcept;
    /// Of the left (0) or the right ear (1).
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
