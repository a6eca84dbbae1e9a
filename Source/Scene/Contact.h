// What happens between bodies that meet, as physics tells sound.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace idiophone {

/// One side of a blow: what acts on one body. Of each blow both sides are told.
struct Impact {
    double seconds = 0;                   ///< when they touched, between two steps
    std::size_t body = 0;                 ///< what is struck
    std::size_t other = 0;                ///< what strikes it
    Eigen::Vector3d pointMetres;          ///< in the body's mesh coordinates
    Eigen::Vector3d impulseNewtonSeconds; ///< likewise, on the body
    double contactSeconds = 0;            ///< of Hertz's contact
    double speedMetresPerSecond = 0;      ///< at which they approached
};

/// Two bodies that keep touching for a step: what slides or rolls.
struct Touch {
    std::array<std::size_t, 2> bodies{};        ///< the first is less than the second
    std::array<Eigen::Vector3d, 2> pointMetres; ///< the middle of the contact in mesh coordinates
    std::array<Eigen::Vector3d, 2> inward;      ///< unit, into each body, in mesh coordinates
    double forceNewtons = 0;                    ///< normal
    double slideMetresPerSecond = 0;            ///< of one surface over the other
    double rollMetresPerSecond = 0;             ///< of the place of contact over both
};

} // namespace idiophone
