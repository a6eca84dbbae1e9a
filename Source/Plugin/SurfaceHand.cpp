#include "Plugin/SurfaceHand.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

// Maximum number of steps between two mouse events; a faster drag is followed more coarsely.
constexpr int maximumSteps = 8;

/// Returns how many steps keep each within a mesh edge, up to `maximumSteps`.
int stepsBetween(const std::array<double, 3>& from,
                 const std::array<double, 3>& to,
                 double edgeMetres) {
    const double metres = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    if (!(edgeMetres > 0) || !(metres > edgeMetres))
        return 1;
    return static_cast<int>(std::min(std::ceil(metres / edgeMetres), double(maximumSteps)));
}

} // namespace

void SurfaceHand::strike(const std::shared_ptr<const Instrument>& instrument,
                         std::size_t slot,
                         const std::array<double, 3>& pointMetres,
                         int velocity) {
    const auto& places = placesOn(instrument->slots()[slot].object);
    events.push({.instrument = instrument->serialNumber(),
                 .played = SurfaceStrike{
                     .slot = slot, .point = places.nearest(pointMetres), .velocity = velocity}});
}

void SurfaceHand::scrape(const std::shared_ptr<const Instrument>& instrument,
                         std::size_t slot,
                         const std::array<double, 3>& pointMetres,
                         double pressure) {
    const auto& places = placesOn(instrument->slots()[slot].object);
    const auto touchAt = [&](const std::array<double, 3>& point) {
        events.push({.instrument = instrument->serialNumber(),
                     .played = SurfaceTouch{
                         .slot = slot, .point = places.nearest(point), .pressure = pressure}});
    };
    const bool goesOn = drag && pressure > 0 && drag->instrument == instrument->serialNumber() &&
                        drag->slot == slot;
    if (goesOn) {
        const auto& from = drag->pointMetres;
        const int steps = stepsBetween(from, pointMetres, places.meanEdgeMetres());
        for (int step = 1; step < steps; ++step) {
            std::array<double, 3> between;
            for (std::size_t axis = 0; axis < 3; ++axis)
                between[axis] =
                    from[axis] + (pointMetres[axis] - from[axis]) * step / double(steps);
            touchAt(between);
        }
    }
    touchAt(pointMetres);
    if (pressure > 0)
        drag = {.instrument = instrument->serialNumber(), .slot = slot, .pointMetres = pointMetres};
    else
        drag.reset();
}

const ObjectSurface& SurfaceHand::placesOn(const std::shared_ptr<const ModalObject>& object) {
    if (!surface || surface->object != object)
        surface.emplace(object);
    return surface->places;
}

} // namespace idiophone
