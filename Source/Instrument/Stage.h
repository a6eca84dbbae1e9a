// What a note can set in motion besides a mallet: bodies that strike the instrument's objects by
// and by. Scene has such stages; players know them by this.
#pragma once

#include "Instrument/PlacedBlow.h"
#include "Synth/CellOutput.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace idiophone {

/// Where the body of a slot is: from its object's own mesh, scaled, to the stage; z points up.
struct BodyPose {
    bool isThere = false;
    std::array<float, 3> originMetres{};
    std::array<float, 4> turn{0, 0, 0, 1}; ///< a unit quaternion x, y, z, w
};

/// One player's. Constructed and destroyed off the audio thread; the rest is for the audio thread
/// and neither allocates, locks nor throws, but while it is offline: then it waits for its worker
/// or does its work.
class StagePerformance {
public:
    virtual ~StagePerformance() = default;

    /// A note whose bodies are set in motion at a sample of the cell begun last, or beyond its end.
    virtual void
    cue(int midiNote, int velocity, std::int64_t cell, double sampleInCell) noexcept = 0;

    /// The next cue is the one of that number, from 0 on: what its bodies do by chance is its own.
    virtual void countCuesFrom(std::uint32_t number) noexcept = 0;

    /// What the bodies do in the cell begun last, each slot's into its own output; after
    /// `Synthesiser::beginCell`, once a cell.
    virtual void sound(std::int64_t cell,
                       Synthesiser& synthesiser,
                       std::span<const CellOutput> cellsOfSlots) noexcept = 0;

    /// What presses on the slots lets go, over the cell begun last. The next `sound` presses again
    /// where it goes on.
    virtual void release(Synthesiser& synthesiser,
                         std::span<const CellOutput> cellsOfSlots) noexcept = 0;

    /// What a listener hears of the slots.
    virtual void hear(std::span<const CellOutput> cellsOfSlots,
                      const CellOutput& ears) noexcept = 0;

    /// Whether it may wait until what is to be heard is known. Otherwise blows that become known
    /// too late act as soon as they are, and count as late.
    virtual void setOffline(bool isOffline) noexcept = 0;

    /// Bodies stand still in the air, and go on from there.
    virtual void setPaused(bool isPaused) noexcept = 0;
    /// All bodies are as they were before the first note; what rings goes on.
    virtual void stop() noexcept = 0;
    /// As if nothing had been yet.
    virtual void reset() noexcept = 0;

    /// Nothing is in motion, nor on its way to the listener.
    virtual bool silent() const noexcept = 0;
    virtual std::int64_t lateBlows() const noexcept = 0;
    /// Those that acted since this was asked last, in seconds since the first cell; the next
    /// `sound` forgets them.
    virtual std::span<const PlacedBlow> takeBlows() noexcept = 0;
    /// Another one for every performance of the process, and after every `stop` and `reset`: times
    /// of blows go together with those of the same number.
    virtual std::uint32_t number() const noexcept = 0;
    virtual std::span<const BodyPose> poses() const noexcept = 0; ///< of the slots, as of now
};

/// Immutable, so that any number of players share it.
class Stage {
public:
    virtual ~Stage() = default;

    /// Of an instrument on this stage. The same seed, cues and offline state give the same bits.
    virtual std::unique_ptr<StagePerformance> perform(double sampleRateHz,
                                                      std::uint64_t seed) const = 0;

    /// The object of a slot as its scene has it: the factory's name or a file's path.
    virtual const std::string& objectOf(std::size_t slot) const = 0;
    /// Of the slots, before the first note.
    virtual std::span<const BodyPose> firstPoses() const = 0;
    /// From a note to its first blow, in seconds.
    virtual double delaySeconds() const = 0;
    /// From a note to the last time that its bodies move.
    virtual double lengthSeconds() const = 0;
};

} // namespace idiophone
