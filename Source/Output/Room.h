// The room effect: a diffuse reverb added to the sound.
#pragma once

#include "Output/DelayNetwork.h"
#include "Output/Ramp.h"
#include "Parameters/ParameterTable.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace idiophone {

/// Call `prepare` while nothing processes. The other functions are for the audio thread and do not
/// allocate, lock or throw. The samples do not depend on block sizes.
class Room {
public:
    /// Two channels of equal length.
    struct Sound {
        std::span<const float> left, right;
    };

    /// A tail below this value (−100 dB of full scale, before the level) counts as silence.
    /// Rounding keeps the longest tails at −110 dB forever.
    static constexpr float silence = 1e-5f;

    /// The minimum delay of the reverb.
    static constexpr double earliestSeconds = DelayNetwork::shortestSeconds;

    /// `rampSeconds` is at most `earliestSeconds`.
    void prepare(double sampleRateHz, int maximumBlockSize, double rampSeconds);

    /// Silences the room. The next block starts at its parameter values without a ramp.
    void reset() noexcept;

    /// Fades the reverb over the ramp from the next sample on. The next `unanswered` samples get no
    /// reverb. Later samples get reverb as in a silent room.
    void hush(std::size_t unanswered) noexcept;

    /// Returns the sound with reverb, or the sound itself if the room is off. The result is valid
    /// until the next call. At most `maximumBlockSize` samples.
    Sound process(const Sound& sound, const ParameterValues& values) noexcept;

    /// Passes over silence before the first sound since `prepare` or `reset`.
    void skip(std::size_t samples) noexcept;

    /// Returns true if there is no more reverb.
    bool silent() const noexcept { return isSilent && fadeLeft == 0; }

private:
    void follow(const ParameterValues& values) noexcept;
    bool isShut() const noexcept;
    void rest() noexcept;
    void ring(std::span<float> left, std::span<float> right) noexcept;
    void addFading(std::span<float> left, std::span<float> right) noexcept;

    std::array<DelayNetwork, 2> networks;
    std::size_t playing = 0; ///< index of the active network; the other one fades or is idle
    double rateHz = 44100;
    Ramp<> amount;
    std::vector<float> wetLeft, wetRight, fadingLeft, fadingRight;
    int gridPosition = 0;       ///< of the next sample, in a cell of the silence grid
    int quietSamples = 0;       ///< silent samples before that cell
    bool isSilent = true;       ///< of the active network
    int fadeSamples = 0;        ///< length of the ramp
    int fadeLeft = 0;           ///< remaining samples of the fade
    std::size_t unanswered = 0; ///< samples that get no reverb
    bool startsAtTarget = true;
};

} // namespace idiophone
