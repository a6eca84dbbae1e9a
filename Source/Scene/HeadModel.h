// How a place sounds to two ears: the spherical head of Brown & Duda, "A structural model for
// binaural sound synthesis" (IEEE Trans. Speech and Audio Processing 6(5), 1998), and the air on
// the way. Unlike measured responses it moves without seams and asks for no files.
#pragma once

#include "Scene/Scene.h"

#include <Eigen/Core>
#include <array>

namespace idiophone {

/// From a place to one ear.
struct EarPath {
    double delaySeconds = 0; ///< behind the nearer ear at its nearest, 0 to about 0.95 ms
    /// The head's shadow: (1 + α jω/2ω₀)/(1 + jω/2ω₀), where ω₀ = c/a.
    double highFrequencyGain = 1; ///< α: 0.1 behind the head to 2 before the ear
};

/// From a place to the listener.
struct HeardPath {
    std::array<EarPath, 2> ears;                          ///< of a sphere, left and right
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX(); ///< ahead, left and up of the head
    double gain = 0;                                      ///< 1 at a metre, ∝ 1/distance
    /// What the air leaves of 10 kHz: at 20 °C and 50 % it takes 0.16 dB a metre (ISO 9613-1).
    double airGain = 1;
};

/// The shadow at a sample rate: y = direct x + previous x₁ − feedback y₁.
struct HeadShadow {
    double direct = 1, previous = 0, feedback = 0;

    double energy() const; ///< of its impulse response
};

/// By the bilinear transform; ω₀ is 0.62 kHz for a head of radius 87.5 mm.
HeadShadow headShadow(double highFrequencyGain, double sampleRateHz);

/// The head turns towards where the listener looks, and stands upright. Not closer
/// than `nearestMetres`.
class HeadModel {
public:
    static constexpr double nearestMetres = 0.25;
    static constexpr double longestDelaySeconds = 1e-3;

    explicit HeadModel(const Listener& listener);

    HeardPath path(const Eigen::Vector3d& placeMetres) const;

private:
    Eigen::Vector3d position;
    Eigen::Matrix3d axes;                ///< columns: ahead, left, up
    std::array<Eigen::Vector3d, 2> ears; ///< unit, from the middle of the head
};

} // namespace idiophone
