// A contact that moves along a key's strip: it follows its goal without a jump.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/MalletStrike.h"
#include "Synth/ForceCell.h"

namespace idiophone {

/// For the audio thread; neither allocates, locks nor throws. Moves by cells.
class StripGlide {
public:
    /// Time in which a contact follows its goal, and its maximum speed along the key.
    static constexpr double seconds = 0.02;
    static constexpr double fastestMetresPerSecond = 5;

    /// Goes to a place on a key's strip at once.
    void jumpTo(const Key& key, const StrikePlace& goal) noexcept;
    /// Moves towards a place for the time of a cell. `sizeRatio` is the object's size over that of
    /// its strip.
    void
    moveTo(const Key& key, const StrikePlace& goal, double sizeRatio, double cellSeconds) noexcept;

    /// Returns the force that a hard tool exerts at the present place while it slides towards the
    /// strip's end; without friction it presses only.
    ForcePlace force(double friction = 0) const noexcept;

    /// Returns the force of one newton along the path, or into the surface where the path has no
    /// direction.
    ForcePlace slide() const noexcept;

private:
    StrikePlace now;
    StripStep place;
};

} // namespace idiophone
