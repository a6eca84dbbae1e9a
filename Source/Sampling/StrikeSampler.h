// Plays one strike of an instrument, as the plugin sounds, into memory.
#pragma once

#include "Instrument/KeyTuning.h"
#include "Instrument/Player.h"
#include "Object/Result.h"
#include "Object/WorkControl.h"

#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

namespace idiophone {

/// An instrument and the values with which it sounds.
struct SampledInstrument {
    std::shared_ptr<const Instrument> instrument; ///< not on a stage
    Preset preset; ///< its surface, seed, muted modes and values to match
    ParameterValues values;
    double sampleRateHz = 48000;
    KeyTuning tuning = {}; ///< of the keys
};

/// A key that is struck and held, or a place of an object.
struct SampledStrike {
    struct KeyStrike {
        int key = 60;
        int velocity = 100;
    };
    std::variant<KeyStrike, SurfaceStrike> by;
    std::uint64_t turn = 0; ///< strikes of different turns differ by spread and chatter

    int velocity() const {
        return std::visit([](const auto& strike) { return strike.velocity; }, by);
    }
};

struct StereoSamples {
    std::vector<float> left, right; ///< equal lengths, full scale 1

    float peak() const;
    /// Ends at the last sample within `decibels`, a negative number, of the peak, and fades out
    /// over the 10 ms after it.
    void cutTail(double decibels, double sampleRateHz);
};

/// Renders up to silence, to two seconds below `tailDecibels` (negative, relative to the peak), or
/// to the length in seconds. The first sample is the strike's. The limiter is off, so that strikes
/// keep their loudness relative to each other. Fails if the sound is not finite or the work is
/// cancelled. Any thread except the audio thread, also several at a time.
Result<StereoSamples> sampleStrike(const SampledInstrument& sampled,
                                   const SampledStrike& strike,
                                   double tailDecibels,
                                   double longestSeconds,
                                   const WorkControl& control = {});

} // namespace idiophone
