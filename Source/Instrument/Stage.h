// The interface of a stage, on which a note moves bodies that later strike the instrument's
// objects. The module Scene implements it for players.
#pragma once

#include "Instrument/PlayedStage.h"
#include "Synth/CellOutput.h"
#include "Synth/Synthesiser.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace idiophone {

/// The stage of one player, as the player sounds it. Constructed and destroyed off the audio
/// thread.
class StagePlayer : public PlayedStage {
public:
    /// Starts the bodies of a note at a sample of the newest cell, or beyond its end.
    virtual void
    startNote(int midiNote, int velocity, std::int64_t cell, double sampleInCell) noexcept = 0;

    /// Sets the number of the next note, from 0 on. It seeds the random part of its bodies' motion.
    virtual void countNotesFrom(std::uint32_t number) noexcept = 0;

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

    /// Returns to the constructed state; also clears.
    virtual void reset() noexcept = 0;
    /// Returns whether nothing moves, and no sound is on its way to the listener.
    virtual bool silent() const noexcept = 0;
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
