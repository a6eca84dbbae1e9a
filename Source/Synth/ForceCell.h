// A cell of continuous force: what something that scrapes or rolls does to an object meanwhile.
#pragma once

#include "Synth/Strike.h"
#include "Synth/SynthesisSettings.h"

#include <array>
#include <cstddef>
#include <span>

namespace idiophone {

/// Forces that a synthesiser takes at a time.
inline constexpr std::size_t forceCapacity = 34;

/// A point of an object's surface and the force there for each newton of the signal.
struct ForcePoint {
    StrikePoint point;
    std::array<float, 3> direction{0, 0, -1};

    bool operator==(const ForcePoint&) const = default;
};

/// A place between two neighbouring points of a path. What the object answers at a point is kept
/// for as long as the contact is near, so that only new points cost.
struct ForcePlace {
    std::array<ForcePoint, 2> points;
    float way = 0; ///< 0 at the first to 1 at the second, which is not read at 0

    bool operator==(const ForcePlace&) const = default;
};

struct ForceCell {
    std::size_t contact = 0; ///< below forceCapacity: which of the contacts at that time it is
    ForcePlace start, end;   ///< where the contact is at the cell's start and at its end
    std::span<const float, cellSamples> newtons;
};

} // namespace idiophone
