// Repeatable random numbers: the standard fixes the numbers of its engines, but not those of its
// distributions.
#pragma once

#include "Scene/Scene.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

namespace idiophone {

class SceneRandom {
public:
    /// The random numbers of item `number` among those that a scene's seed decides.
    SceneRandom(std::uint32_t seed, std::uint32_t number) {
        std::seed_seq both{seed, number};
        engine.seed(both);
    }

    /// Returns a uniform number from −1 to 1.
    double spread() { return static_cast<double>(engine() >> 11) * 0x1p-52 - 1; }

    Eigen::Vector3d draw(const Scattered& quantity) {
        Eigen::Vector3d drawn = quantity.mean;
        for (int axis = 0; axis < 3; ++axis)
            drawn(axis) += quantity.reach(axis) * spread();
        return drawn;
    }

    /// Returns a uniform random rotation (Shoemake 1992).
    Eigen::Quaterniond turn() {
        const double share = (spread() + 1) / 2;
        const double first = std::numbers::pi * spread(), second = std::numbers::pi * spread();
        return {std::sqrt(1 - share) * std::sin(first), std::sqrt(1 - share) * std::cos(first),
                std::sqrt(share) * std::sin(second), std::sqrt(share) * std::cos(second)};
    }

private:
    std::mt19937_64 engine;
};

} // namespace idiophone
