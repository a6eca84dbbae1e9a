// The hand that strikes objects in the window and drags over them: from a place on a surface to the
// audio thread.
#pragma once

#include "Instrument/ObjectSurface.h"
#include "Instrument/Player.h"
#include "Plugin/OneWayQueue.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

namespace idiophone {

class SurfaceHand {
public:
    /// [message thread] Strikes the slot's object at the place nearest to a point, in metres of its
    /// own mesh, as struck at its next sample; velocity 1 to 127, or 0 to lift the hand. Of a full
    /// queue the blow is lost, but never that a hand is lifted. The slot exists.
    void strike(const std::shared_ptr<const Instrument>& instrument,
                std::size_t slot,
                const std::array<double, 3>& pointMetres,
                int velocity);

    /// [message thread] Drags over the slot's object, straight to the place nearest to a point;
    /// pressure 0 to 1, or 0 to lift the hand. Of a full queue the way there is lost, but never
    /// that a hand is lifted. The slot exists.
    void scrape(const std::shared_ptr<const Instrument>& instrument,
                std::size_t slot,
                const std::array<double, 3>& pointMetres,
                double pressure);

    /// [audio thread] Gives what waits to the player of its instrument; what is meant for another
    /// instrument, which has gone since, is dropped. Neither allocates, locks nor throws.
    void playOn(Player* player) noexcept;

    /// [audio thread] Forgets what waits, where all hands are lifted.
    void clear() noexcept;

private:
    /// A blow or a touch.
    struct Gesture {
        std::uint64_t instrument = 0; ///< its serial number
        bool isTouch = false;
        SurfaceStrike strike;
        SurfaceTouch touch;
    };
    /// Where the hand was dragged to last.
    struct Drag {
        std::uint64_t instrument = 0; ///< its serial number
        std::size_t slot = 0;
        std::array<double, 3> pointMetres{};
    };
    /// Of the object played last, which it keeps alive.
    struct Surface {
        explicit Surface(std::shared_ptr<const ModalObject> played)
            : object(std::move(played)), places(*object) {}

        std::shared_ptr<const ModalObject> object;
        ObjectSurface places;
    };

    const ObjectSurface& placesOn(const std::shared_ptr<const ModalObject>& object);
    void push(const Gesture& gesture, bool lifts) noexcept;

    OneWayQueue<Gesture, 256> gestures;
    std::atomic<bool> liftLost{false}; ///< for want of room: all hands are to be lifted
    std::optional<Surface> surface;
    std::optional<Drag> drag;
};

} // namespace idiophone
