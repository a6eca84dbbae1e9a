// The collisions and contacts that the rigid bodies report to the sound.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace idiophone {

/// The effect of a collision on one of its two bodies. Every collision yields two of them.
struct Impact {
    double seconds = 0;                   ///< when the bodies met, between two steps
    std::size_t body = 0;                 ///< the struck body
    std::size_t other = 0;                ///< the striking body
    Eigen::Vector3d pointMetres;          ///< in the mesh coordinates of `body`
    Eigen::Vector3d impulseNewtonSeconds; ///< on `body`, in its mesh coordinates
    double contactSeconds = 0;            ///< duration of the Hertz contact
    double speedMetresPerSecond = 0;      ///< approach speed
};

/// A contact that lasts for a whole step: two bodies slide or roll on each other.
struct Touch {
    std::array<std::size_t, 2> bodies{};        ///< the first number is less than the second
    std::array<Eigen::Vector3d, 2> pointMetres; ///< middle of the contact, in mesh coordinates
    std::array<Eigen::Vector3d, 2> inward;      ///< unit vector into each body, in mesh coordinates
    double forceNewtons = 0;                    ///< normal force
    double slideMetresPerSecond = 0;            ///< speed of one surface over the other
    double rollMetresPerSecond = 0;             ///< speed of the contact point over both surfaces
};

} // namespace idiophone
