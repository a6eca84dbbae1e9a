// Finds where the mouse strikes or drags over an object, and queues it for the audio thread.
#pragma once

#include "Plugin/WindowEvents.h"
#include "World/ObjectSurface.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace idiophone {

/// For the message thread.
class SurfaceHand {
public:
    explicit SurfaceHand(WindowEvents& eventsOfWindow) : events(eventsOfWindow) {}

    /// Strikes the slot's object at the place nearest to a point, in metres of its own mesh. The
    /// strike acts at the next sample. Velocity is 1 to 127; 0 lifts the hand. A full queue loses
    /// strikes, but no lifts. `slot` must exist.
    void strike(const std::shared_ptr<const Instrument>& instrument,
                std::size_t slot,
                const std::array<double, 3>& pointMetres,
                int velocity);

    /// Drags over the slot's object, straight to the place nearest to a point. Pressure is 0 to 1;
    /// 0 lifts the hand. A full queue loses part of the path, but no lifts. `slot` must exist.
    void scrape(const std::shared_ptr<const Instrument>& instrument,
                std::size_t slot,
                const std::array<double, 3>& pointMetres,
                double pressure);

private:
    /// The last place of the drag.
    struct Drag {
        std::uint64_t instrument = 0; ///< its serial number
        std::size_t slot = 0;
        std::array<double, 3> pointMetres{};
    };
    /// Surface of the object played last; keeps the object alive.
    struct Surface {
        explicit Surface(std::shared_ptr<const ModalObject> played)
            : object(std::move(played)), places(*object) {}

        std::shared_ptr<const ModalObject> object;
        ObjectSurface places;
    };

    const ObjectSurface& placesOn(const std::shared_ptr<const ModalObject>& object);

    WindowEvents& events;
    std::optional<Surface> surface;
    std::optional<Drag> drag;
};

} // namespace idiophone
