// The way of a contact that is drawn over a surface by hand: corners that come one by one, and a
// point that is pulled after the last of them as by a critically damped spring.
#pragma once

#include "Synth/ForceCell.h"

#include <array>
#include <cstddef>

namespace idiophone {

/// Lengths and speeds are those of the object's own mesh. For the audio thread; does not allocate.
class SurfacePath {
public:
    using Point = std::array<double, 3>; ///< metres

    /// Corners ahead of the contact; of more the last one moves.
    static constexpr std::size_t capacity = 64;
    /// 1/ω of the spring: what hands and their 60 events a second do is smooth, and a stop takes
    /// some 0.1 s.
    static constexpr double springSeconds = 0.015; // by ear

    /// At rest at a place.
    void begin(const StrikePoint& place, const Point& metres) noexcept;
    /// The way goes on, straight, to another place. Where it already ends there nothing happens.
    void extendTo(const StrikePoint& place, const Point& metres) noexcept;

    /// Moves on, no faster than `fastest`, and returns the speed at the end, both in m/s.
    double advance(double seconds, double fastest) noexcept;

    /// Between the two corners around the contact: for each newton one into the surface, and
    /// `friction` along the way.
    ForcePlace place(double friction) const noexcept;

private:
    struct Corner {
        StrikePoint place;
        Point metres{};
        std::array<float, 3> direction{}; ///< of the way there, along the surface: unit, or zero
        double along = 0;                 ///< length of the way there from the first of all
    };

    Corner& corner(std::size_t index) noexcept { return corners[(first + index) % capacity]; }
    const Corner& corner(std::size_t index) const noexcept {
        return corners[(first + index) % capacity];
    }

    std::array<Corner, capacity> corners{};
    std::size_t first = 0;
    std::size_t count = 1; ///< the contact is between the first two, or at the only one
    double position = 0;   ///< along the way
    double speed = 0;
};

} // namespace idiophone
