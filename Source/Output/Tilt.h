// The brightness control: tilts the spectrum about a middle frequency.
#pragma once

#include "Output/Ramp.h"
#include "Output/Room.h"

#include <array>
#include <vector>

namespace idiophone {

/// Divides the sound into two parts by a filter of first order and scales them inversely. Call
/// `prepare` while nothing processes. The other functions are for the audio thread and do not
/// allocate, lock or throw. The samples do not depend on block sizes.
class Tilt {
public:
    /// High frequencies get up to this much, low ones as much less.
    static constexpr double maximumDecibels = 9;
    static constexpr double middleHz = 1000;

    void prepare(double sampleRateHz, int maximumBlockSize, double rampSeconds);

    /// The next block starts at its brightness without a ramp.
    void reset() noexcept;

    /// Returns the tilted sound, or the sound itself at a brightness of 0. `brightness` is −100 to
    /// 100. The result is valid until the next call. At most `maximumBlockSize` samples.
    Room::Sound process(const Room::Sound& sound, double brightness) noexcept;

private:
    struct Channel {
        std::vector<float> tilted;
        float state = 0; ///< of the low-pass filter
    };

    std::array<Channel, 2> channels;
    Ramp<RampSteps::ratios> gain; ///< high part's
    float coefficient = 0;        ///< of the low-pass filter
    bool startsAtTarget = true;
};

} // namespace idiophone
