// The room that everything sounds in: a diffuse tail behind the sound itself.
#pragma once

#include "Output/DelayNetwork.h"
#include "Parameters/ParameterTable.h"

#include <array>
#include <cstddef>
#include <juce_dsp/juce_dsp.h>
#include <span>
#include <vector>

namespace idiophone {

/// `prepare` is called while nothing processes; the rest is for the audio thread and neither
/// allocates, locks nor throws. The samples do not depend on block sizes.
class Room {
public:
    /// Two channels of one length.
    struct Sound {
        std::span<const float> left, right;
    };

    /// What dies away and is fainter than this, −100 dB of full scale before the level, is silence:
    /// rounding holds the longest tails at −110 dB for ever.
    static constexpr float silence = 1e-5f;

    /// The room's sound comes no sooner after what it answers.
    static constexpr double earliestSeconds = DelayNetwork::shortestSeconds;

    /// The ramp is no longer than `earliestSeconds`.
    void prepare(double sampleRateHz, int maximumBlockSize, double rampSeconds);

    /// The room is silent, and the next block starts with its values, without a ramp.
    void reset() noexcept;

    /// From the next sample on what rings in the room fades with the ramp. The next `unanswered`
    /// samples sound without it; what comes then is answered as in a silent room.
    void hush(std::size_t unanswered) noexcept;

    /// The sound with the room's, until the next call: where no room is heard, the sound itself. At
    /// most `maximumBlockSize` samples.
    Sound process(const Sound& sound, const ParameterValues& values) noexcept;

    /// Nothing rings in it any more.
    bool silent() const noexcept { return isSilent && fadeLeft == 0; }

private:
    void follow(const ParameterValues& values) noexcept;
    bool isShut() const noexcept;
    void rest() noexcept;
    void ring(std::span<float> left, std::span<float> right) noexcept;
    void addFading(std::span<float> left, std::span<float> right) noexcept;

    std::array<DelayNetwork, 2> networks;
    std::size_t playing = 0; ///< of them; the other one fades, or is not used
    double rateHz = 44100;
    juce::SmoothedValue<float> amount;
    std::vector<float> wetLeft, wetRight, fadingLeft, fadingRight;
    int gridPosition = 0; ///< of the next sample, in a cell of the grid on which silence is found
    int quietSamples = 0; ///< up to that cell
    bool isSilent = true; ///< the network that plays
    int fadeSamples = 0;  ///< the ramp
    int fadeLeft = 0;     ///< of those
    std::size_t unanswered = 0; ///< of the next samples
    bool startsAtTarget = true;
};

} // namespace idiophone
