// The path of a contact that a hand drags over a surface. The hand adds corners; a critically
// damped spring pulls the contact after the last one.
#pragma once

#include "Synth/ForceCell.h"

#include <array>
#include <cstddef>

namespace idiophone {

/// Lengths and speeds are those of the object's own mesh. For the audio thread; does not allocate.
class SurfacePath {
public:
    using Point = std::array<double, 3>; ///< metres

    /// Maximum of corners ahead of the contact; a further corner replaces the last one.
    static constexpr std::size_t capacity = 64;
    /// 1/ω of the spring. It smooths a hand's 60 events a second; a stop takes about 0.1 s.
    static constexpr double springSeconds = 0.015; // by ear

    /// Places the contact, at rest.
    void begin(const StrikePoint& place, const Point& metres) noexcept;
    /// Extends the path straight to another place. Does nothing if it ends there already.
    void extendTo(const StrikePoint& place, const Point& metres) noexcept;

    /// Moves on, no faster than `fastest`, and returns the final speed, both in m/s.
    double advance(double seconds, double fastest) noexcept;

    /// Returns the contact between the two corners around it, with the force per newton of
    /// pressure: one newton into the surface plus `friction` along the path.
    ForcePlace place(double friction) const noexcept;

private:
    struct Corner {
        StrikePoint place;
        Point metres{};
        std::array<float, 3>
            direction{};  ///< path direction to here along the surface: unit, or zero
        double along = 0; ///< path length from the first corner of all
    };

    Corner& corner(std::size_t index) noexcept { return corners[(first + index) % capacity]; }
    const Corner& corner(std::size_t index) const noexcept {
        return corners[(first + index) % capacity];
    }

    std::array<Corner, capacity> corners{};
    std::size_t first = 0;
    std::size_t count = 1; ///< the contact lies between the first two, or at the only one
    double position = 0;   ///< along the way
    double speed = 0;
};

} // namespace idiophone
