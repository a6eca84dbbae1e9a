// SPDX-License-Identifier: Apache-2.0
// The path of sound from a place to two ears: the spherical head of Brown & Duda, "A structural
// model for binaural sound synthesis" (IEEE Trans. Speech and Audio Processing 6(5), 1998), and the
// air. Unlike measured responses it changes continuously with the direction and needs no files.
#pragma once

#include <Eigen/Core>
#include <array>

namespace idiophone {

/// The place of a listener, in metres.
struct Listener {
    Eigen::Vector3d positionMetres{0, -1.5, 1.5};
    Eigen::Vector3d towardsMetres{0, 0, 0.5}; ///< the point that the listener looks at
    Eigen::Vector3d up{0, 0, 1};              ///< of any length
};

/// The path of sound from a place to one ear.
struct EarPath {
    double delaySeconds = 0; ///< 0 if the sound comes straight at this ear, at most about 0.95 ms
    /// The head's shadow is the filter (1 + α jω/2ω₀)/(1 + jω/2ω₀), where ω₀ = c/a.
    double highFrequencyGain = 1; ///< α: 0.1 behind the head to 2 in front of the ear
};

/// The path of sound from a place to the listener.
struct HeardPath {
    std::array<EarPath, 2> ears;                          ///< of a sphere, left and right
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX(); ///< ahead, left and up of the head
    double gain = 0;                                      ///< 1 at one metre, ∝ 1/distance
    /// Gain of the air at 10 kHz. At 20 °C and 50 % humidity, air absorbs 0.16 dB a metre (ISO
    /// 9613-1).
    double airGain = 1;
};

/// The head's shadow at a sample rate: y = direct x + previous x₁ − feedback y₁.
struct HeadShadow {
    double direct = 1, previous = 0, feedback = 0;

    double energy() const; ///< of the impulse response
};

/// Designs the filter by the bilinear transform. For a head radius of 87.5 mm, ω₀ is 0.62 kHz.
HeadShadow headShadow(double highFrequencyGain, double sampleRateHz);

/// The head stands upright and turns towards the point that the listener looks at. Sources closer
/// than `nearestMetres` are treated as if they were at that distance.
class HeadModel {
public:
    static constexpr double nearestMetres = 0.25;
    static constexpr double longestDelaySeconds = 1e-3;

    explicit HeadModel(const Listener& listener);

    HeardPath path(const Eigen::Vector3d& placeMetres) const;

private:
    Eigen::Vector3d position;
    Eigen::Matrix3d axes;                ///< columns: ahead, left, up
    std::array<Eigen::Vector3d, 2> ears; ///< unit vectors from the middle of the head
};

} // namespace idiophone
