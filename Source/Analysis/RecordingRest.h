// Divides the energy of a recording among its modes and the rest, and says so in a sentence.
#pragma once

#include "Analysis/DampedSinusoid.h"

#include <span>
#include <string>
#include <vector>

namespace idiophone {

/// Shares of the energy of a free decay. They sum to about 1.
struct RecordingRest {
    double modes = 0;             ///< the kept modes
    double contact = 0;           ///< what else sounds in the first 20 ms
    double steadyTones = 0;       ///< hum and other tones that do not decay
    double noise = 0;             ///< steady noise and rumble
    double others = 0;            ///< the room and modes that were not kept
    std::vector<double> steadyHz; ///< ascending

    /// Returns a sentence, such as "The modes hold 97.1 % of the sound; the rest is ...".
    std::string sentence() const;
};

/// `rest` is the recording minus all modes and steady tones, `steadyTones` those with their
/// amplitudes in the recording. `noiseEnergy` is the mean square of the noise.
RecordingRest restOf(const DecayRecording& recording,
                     std::span<const double> rest,
                     std::span<const DampedSinusoid> steadyTones,
                     std::size_t index,
                     double noiseEnergy);

} // namespace idiophone
