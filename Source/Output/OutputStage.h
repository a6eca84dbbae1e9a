// The last stage of plugin and console: it applies brightness, room, width, level, volume, bypass
// and limiter to the sound and writes the output channels. Independent of hosts, files and buses.
#pragma once

#include "Output/Limiter.h"
#include "Output/Ramp.h"
#include "Output/Room.h"
#include "Output/Tilt.h"
#include "Parameters/ParameterTable.h"

#include <cstddef>
#include <span>
#include <vector>

namespace idiophone {

/// Call `prepare` while nothing processes. The other functions are for the audio thread and do not
/// allocate, lock or throw. At constant parameters the samples do not depend on block sizes.
class OutputStage {
public:
    /// The ramp of level, bypass, width, brightness, room and limiter switch. It is long enough to
    /// avoid steps and too short to be heard as a fade (by ear).
    static constexpr double rampSeconds = 0.02;
    static_assert(rampSeconds <= Room::earliestSeconds);

    void prepare(double sampleRateHz, int maximumBlockSize);

    /// Silences the stage. The next block starts at its parameter values without a ramp.
    void reset() noexcept;

    /// Starts another sound with the next block. Its level applies at once, because levels differ
    /// by tens of decibels. Reverb of the old sound keeps its level. Returns the old level divided
    /// by the new one. The caller scales the old sound's fade by it. The level stays constant for
    /// `fadeSeconds`.
    float changeSound(const ParameterValues& values, double fadeSeconds = 0) noexcept;

    /// Writes `left.size()` samples, at most `maximumBlockSize`, to each channel. L and R are the
    /// inputs with reverb, M = (L + R)/2, S = (L − R)/2, and w is the width. Two channels get M +
    /// wS and M − wS; one channel gets M. The channels may be `left` and `right` themselves. Values
    /// apply from the first sample on. If a sample is not finite, writes silence, resets the stage
    /// and returns false.
    bool process(std::span<const float> left,
                 std::span<const float> right,
                 std::span<float* const> channels,
                 const ParameterValues& values) noexcept;

    /// Passes over silence before the first sound since `prepare` or `reset`. What follows is as if
    /// `process` had been called for it at constant values.
    void skip(std::size_t samples) noexcept;

    /// Fades the reverb out over the ramp. Only input after the next `unanswered` samples makes new
    /// reverb.
    void hush(std::size_t unanswered) noexcept { room.hush(unanswered); }

    /// Returns true if there is no more reverb.
    bool silent() const noexcept { return room.silent(); }

private:
    bool processPiece(std::span<const float> left,
                      std::span<const float> right,
                      std::span<float* const> channels,
                      const ParameterValues& values) noexcept;
    Room::Sound atOwnLevel(const Room::Sound& sound) noexcept;
    void forgetChanges() noexcept;
    void moveLevelBehindRoom() noexcept;
    void spread(const Room::Sound& sound, std::span<float* const> channels) noexcept;

    Tilt tilt;
    Room room;
    Limiter limiter;
    /// The level is `ownLevel` times `level`. `ownLevel` applies to the current sound before the
    /// room, and not to older reverb. `level` does not rise until the room is silent.
    Ramp<> ownLevel, level;
    float ownLevelAtChange = 1, highestLevel = 0;
    std::size_t heldSamples = 0;  ///< samples for which the level stays constant
    std::size_t gridPosition = 0; ///< of the next sample
    double samplesPerSecond = 44100;
    Ramp<> open, width; ///< `open`: 0 in bypass, else 1
    std::vector<float> ownLeft, ownRight;
    bool startsAtTarget = true;
};

} // namespace idiophone
