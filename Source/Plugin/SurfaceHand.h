// The hand that strikes objects in the window: from a place on a surface to the audio thread.
#pragma once

#include "Instrument/ObjectSurface.h"
#include "Instrument/Player.h"
#include "Plugin/OneWayQueue.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace idiophone {

/// The slots of an instrument that are objects of their own: of those that share an object the one
/// nearest to its own size. Ascending.
std::vector<std::size_t> ownSlots(const Instrument& instrument);

class SurfaceHand {
public:
    /// [message thread] Strikes the slot's object at the place nearest to a point, in metres of its
    /// own mesh, as struck at its next sample; velocity 1 to 127, or 0 to lift the hand. Of a full
    /// queue the blow is lost. The slot exists.
    void strike(const std::shared_ptr<const Instrument>& instrument,
                std::size_t slot,
                const std::array<double, 3>& pointMetres,
                int velocity);

    /// [audio thread] Gives the blows that wait to the player of their instrument; those on another
    /// instrument, which has gone since, are dropped. Neither allocates, locks nor throws.
    void strikeOn(Player* player) noexcept;

private:
    struct Blow {
        const Instrument* instrument = nullptr; ///< compared, never read
        SurfaceStrike strike;
    };
    /// Of the object struck last, which it keeps alive.
    struct Surface {
        explicit Surface(std::shared_ptr<const ModalObject> struck)
            : object(std::move(struck)), places(*object) {}

        std::shared_ptr<const ModalObject> object;
        ObjectSurface places;
    };

    OneWayQueue<Blow, 256> blows;
    std::optional<Surface> surface;
};

} // namespace idiophone
