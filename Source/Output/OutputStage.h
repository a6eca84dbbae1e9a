// The last stage, shared by plugin and console: both channels of the sound to the channels of the
// output, in the room and at the width, level and bypass that the parameters say, through the
// limiter. Knows nothing of hosts, files or buses.
#pragma once

#include "Output/Limiter.h"
#include "Output/Room.h"
#include "Parameters/ParameterTable.h"

#include <cstddef>
#include <juce_dsp/juce_dsp.h>
#include <span>
#include <vector>

namespace idiophone {

/// `prepare` is called while nothing processes; the rest is for the audio thread and neither
/// allocates, locks nor throws. At constant parameters the samples do not depend on block sizes.
class OutputStage {
public:
    /// Level, bypass, width, the room's share and the limiter's switch move linearly over this
    /// time: without steps, too fast to be heard as a fade (by ear).
    static constexpr double rampSeconds = 0.02;
    static_assert(rampSeconds <= Room::earliestSeconds);

    void prepare(double sampleRateHz, int maximumBlockSize);

    /// The next block starts at its level, width and room, without a ramp, and nothing sounds on.
    void reset() noexcept;

    /// From the next block on another sound plays. Its level holds at once and not after a ramp, as
    /// levels are tens of decibels apart; what sounds on in the room keeps the one that it had.
    /// Returns what that was, to the new one: with it whatever is still heard of the sound before
    /// keeps its level, and for so long the level stays where it is.
    float changeSound(const ParameterValues& values, double fadeSeconds = 0) noexcept;

    /// Writes `left.size()` samples, at most `maximumBlockSize`, to each channel, L and R with what
    /// the room adds. Of two, the first gets M + wS and the second M − wS, where M = (L + R)/2, S =
    /// (L − R)/2 and w is the width; one gets M. Left may be the first of them and right the
    /// second. Values act from the block's first sample on. False where a sample would not be
    /// finite: the block is silent then, and the next one comes as after a reset.
    bool process(std::span<const float> left,
                 std::span<const float> right,
                 std::span<float* const> channels,
                 const ParameterValues& values) noexcept;

    /// From the next sample on what sounds on in the room fades within the ramp. To the next
    /// `unanswered` samples the room adds nothing, to what comes then all it has.
    void hush(std::size_t unanswered) noexcept { room.hush(unanswered); }

    /// Nothing sounds on in the room.
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

    Room room;
    Limiter limiter;
    /// The level is `ownLevel` times `level`. What plays has the first before the room, and so what
    /// rings there of older sounds has not; nor does the second rise until the room is silent.
    juce::SmoothedValue<float> ownLevel, level;
    float ownLevelAtChange = 1, highestLevel = 0;
    std::size_t heldSamples = 0;  ///< the level stays until then
    std::size_t gridPosition = 0; ///< of the next sample
    double samplesPerSecond = 44100;
    juce::SmoothedValue<float> open, width; ///< `open`: 0 in bypass, else 1
    std::vector<float> ownLeft, ownRight;
    bool startsAtTarget = true;
};

} // namespace idiophone
