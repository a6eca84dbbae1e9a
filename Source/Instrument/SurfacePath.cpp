#include "Instrument/SurfacePath.h"

#include "Instrument/DraggedForce.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

constexpr double shortestStepMetres = 1e-9, arrivedMetres = 1e-7;

/// Returns the direction from `from` to `to` along a surface of this normal: unit, or zero if it
/// leads straight into the surface.
std::array<float, 3> directionAlong(const SurfacePath::Point& from,
                                    const SurfacePath::Point& to,
                                    const std::array<float, 3>& normal) {
    SurfacePath::Point step{};
    double into = 0, square = 0, all = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        step[axis] = to[axis] - from[axis];
        into += step[axis] * static_cast<double>(normal[axis]);
        all += step[axis] * step[axis];
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        step[axis] -= into * static_cast<double>(normal[axis]);
        square += step[axis] * step[axis];
    }
    std::array<float, 3> direction{};
    if (square > 1e-6 * all)
        for (std::size_t axis = 0; axis < 3; ++axis)
            direction[axis] = static_cast<float>(step[axis] / std::sqrt(square));
    return direction;
}

} // namespace

void SurfacePath::begin(const StrikePoint& place, const Point& metres) noexcept {
    first = 0;
    count = 1;
    position = speed = 0;
    corners[0] = {.place = place, .metres = metres, .direction = {}, .along = 0};
}

void SurfacePath::extendTo(const StrikePoint& place, const Point& metres) noexcept {
    if (count == capacity)
        --count;
    const Corner& last = corner(count - 1);
    const double step = std::hypot(metres[0] - last.metres[0], metres[1] - last.metres[1],
                                   metres[2] - last.metres[2]);
    if (!(step > shortestStepMetres))
        return;
    corner(count) = {.place = place,
                     .metres = metres,
                     .direction = directionAlong(last.metres, metres, place.normal),
                     .along = last.along + step};
    ++count;
}

// Integrates the spring exactly. A contact that starts from rest behind the path's end never
// overshoots.
double SurfacePath::advance(double seconds, double fastest) noexcept {
    const double stiffness = 1 / springSeconds;
    const double end = corner(count - 1).along;
    const double behind = position - end;
    const double pull = speed + stiffness * behind;
    const double left = std::exp(-stiffness * seconds);
    const double goal = end + (behind + pull * seconds) * left;
    position = std::clamp(goal, position, position + fastest * seconds);
    speed = std::clamp((speed - stiffness * pull * seconds) * left, 0.0, fastest);
    if (end - position < arrivedMetres) {
        position = end;
        speed = 0;
    }
    while (count > 2 && position >= corner(1).along) {
        first = (first + 1) % capacity;
        --count;
    }
    return speed;
}

ForcePlace SurfacePath::place(double friction) const noexcept {
    const Corner& from = corner(0);
    const ForcePoint start = draggedForce(from.place, from.direction, friction);
    if (count == 1)
        return {.points = {start, start}, .fraction = 0};
    const Corner& to = corner(1);
    const double fraction = (position - from.along) / (to.along - from.along);
    return {.points = {start, draggedForce(to.place, to.direction, friction)},
            .fraction = static_cast<float>(std::clamp(fraction, 0.0, 1.0))};
}

} // namespace idiophone
