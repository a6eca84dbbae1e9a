// The stage of a player, as its owner controls and watches it. This class itself is the stage of a
// player without one: nothing is on it.
#pragma once

#include "Instrument/PlacedImpact.h"

#include <array>
#include <cstdint>
#include <span>

namespace idiophone {

/// Transform of a slot's body from its object's own mesh, scaled, to the stage; z points up.
struct BodyPose {
    bool isThere = false;
    std::array<float, 3> originMetres{};
    std::array<float, 4> turn{0, 0, 0, 1}; ///< a unit quaternion x, y, z, w
};

/// For the audio thread; neither allocates, locks nor throws. The exception is offline mode: then
/// it waits for its worker, or does the work itself.
class PlayedStage {
public:
    virtual ~PlayedStage() = default;

    /// Sets whether it may wait for the simulation. If not, impacts that become known too late act
    /// as soon as possible, and contacts act from then on. Both count as late events.
    virtual void setOffline(bool) noexcept {}
    /// Simulates some ten milliseconds of each note whose bodies move. Returns false if the
    /// simulation is as far ahead of the sound as its worker would be, about a second. Not for the
    /// audio thread, but for its caller between two blocks.
    virtual bool simulateAhead() noexcept { return false; }
    /// Returns when the simulation is that far ahead.
    void waitForSimulation() noexcept {
        while (simulateAhead())
            continue;
    }

    /// Stops bodies in place, or lets them go on from there.
    virtual void pause(bool) noexcept {}
    /// Returns all bodies to their state before the first note; objects ring on.
    virtual void clear() noexcept {}

    virtual std::int64_t lateEvents() const noexcept { return 0; }
    /// Returns the impacts since the last call, in seconds since the first cell; valid until the
    /// next cell.
    virtual std::span<const PlacedImpact> takeImpacts() noexcept { return {}; }
    /// Returns a number unique in the process, which changes with every `clear`; 0 without a stage.
    /// Times of impacts are comparable only under the same number.
    virtual std::uint32_t number() const noexcept { return 0; }
    virtual std::span<const BodyPose> bodyPoses() const noexcept { return {}; } ///< [slots] now
};

} // namespace idiophone
