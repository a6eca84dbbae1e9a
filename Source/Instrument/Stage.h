// The interface of a stage, on which a note moves bodies that later strike the instrument's
// objects. The module Scene implements it for players.
#pragma once

#include "Instrument/PlacedImpact.h"
#include "Synth/CellOutput.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace idiophone {

/// Transform of a slot's body from its object's own mesh, scaled, to the stage; z points up.
struct BodyPose {
    bool isThere = false;
    std::array<float, 3> originMetres{};
    std::array<float, 4> turn{0, 0, 0, 1}; ///< a unit quaternion x, y, z, w
};

/// The stage of one player. Constructed and destroyed off the audio thread; the rest is for the
/// audio thread and neither allocates, locks nor throws. The exception is offline mode: then it
/// waits for its worker, or does the work itself.
class StagePlayer {
public:
    virtual ~StagePlayer() = default;

    /// Starts the bodies of a note at a sample of the newest cell, or beyond its end.
    virtual void
    startNote(int midiNote, int velocity, std::int64_t cell, double sampleInCell) noexcept = 0;

    /// Sets the number of the next note, from 0 on. It seeds the random part of its bodies' motion.
    virtual void countNotesFrom(std::uint32_t number) noexcept = 0;

    /// Waits until the simulation is as far ahead of the sound as its worker would be, about a
    /// second. For the caller of the audio thread's functions, between two blocks.
    virtual void waitForSimulation() noexcept = 0;

    /// Adds the sound of the bodies in the newest cell, each slot's to its own output. Call it once
    /// a cell, after `Synthesiser::beginCell`.
    virtual void sound(std::int64_t cell,
                       Synthesiser& synthesiser,
                       std::span<const CellOutput> cellsOfSlots) noexcept = 0;

    /// Fades all contact forces on the slots out over the newest cell. The next `sound` applies
    /// them again if they continue.
    virtual void release(Synthesiser& synthesiser,
                         std::span<const CellOutput> cellsOfSlots) noexcept = 0;

    /// Mixes the slots to the listener's ears.
    virtual void hear(std::span<const CellOutput> cellsOfSlots,
                      const CellOutput& ears) noexcept = 0;

    /// Sets whether the stage may wait for the simulation. If not, impacts that become known too
    /// late act as soon as possible, and contacts act from then on. Both count as late events.
    virtual void setOffline(bool isOffline) noexcept = 0;

    /// Stops bodies in place; later they go on from there.
    virtual void setPaused(bool isPaused) noexcept = 0;
    /// Resets all bodies to their state before the first note; objects ring on.
    virtual void stop() noexcept = 0;
    /// Restores the constructed state.
    virtual void reset() noexcept = 0;

    /// Returns whether nothing moves, and no sound is on its way to the listener.
    virtual bool silent() const noexcept = 0;
    virtual std::int64_t lateEvents() const noexcept = 0;
    /// Returns the impacts since the last call, in seconds since the first cell. The next `sound`
    /// drops them.
    virtual std::span<const PlacedImpact> takeImpacts() noexcept = 0;
    /// Returns a number unique in the process, which changes with every `stop` and `reset`. Times
    /// of impacts are comparable only under the same number.
    virtual std::uint32_t number() const noexcept = 0;
    virtual std::span<const BodyPose> poses() const noexcept = 0; ///< present poses of the slots
};

/// Immutable, so any number of players share it.
class Stage {
public:
    virtual ~Stage() = default;

    /// Makes a player of this stage. The same seed, notes and offline state give the same bits.
    virtual std::unique_ptr<StagePlayer> makePlayer(double sampleRateHz,
                                                    std::uint64_t seed) const = 0;

    /// Returns the name of a slot's object in the scene: a factory object or a file's path.
    virtual const std::string& objectOf(std::size_t slot) const = 0;
    /// Returns the poses of the slots before the first note.
    virtual std::span<const BodyPose> firstPoses() const = 0;
    /// Returns the time from a note to its first impact, in seconds.
    virtual double delaySeconds() const = 0;
    /// Returns the time from a note until its bodies no longer move, in seconds.
    virtual double lengthSeconds() const = 0;
};

} // namespace idiophone
