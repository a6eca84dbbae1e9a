#include "Instrument/StripGlide.h"

#include "Instrument/DraggedForce.h"

#include <algorithm>
#include <cmath>

namespace idiophone {

void StripGlide::jumpTo(const Key& key, const StrikePlace& goal) noexcept {
    now = goal;
    place = key.strip->around(now.along, now.across);
}

void StripGlide::moveTo(const Key& key,
                        const StrikePlace& goal,
                        double sizeRatio,
                        double cellSeconds) noexcept {
    const double furthest =
        fastestMetresPerSecond * cellSeconds / (key.strip->lengthMetres * sizeRatio);
    const double share = -std::expm1(-4 * cellSeconds / seconds); // 98 % in `seconds`
    now.along += std::clamp(share * (goal.along - now.along), -furthest, furthest);
    now.across += share * (goal.across - now.across);
    place = key.strip->around(now.along, now.across);
}

ForcePlace StripGlide::force(double friction) const noexcept {
    return {.points = {draggedForce(place.first.point, place.first.direction, friction),
                       draggedForce(place.second.point, place.second.direction, friction)},
            .fraction = static_cast<float>(place.fraction)};
}

ForcePlace StripGlide::slide() const noexcept {
    ForcePlace along = force();
    for (std::size_t k = 0; k < along.points.size(); ++k) {
        const auto& direction = (k == 0 ? place.first : place.second).direction;
        if (direction != std::array<float, 3>{})
            along.points[k].direction = direction;
    }
    return along;
}

} // namespace idiophone
