// Describes samples as an SFZ file, which samplers load (sfzformat.com).
#pragma once

#include "Sampling/SamplePlan.h"

#include <optional>
#include <span>
#include <string>

namespace idiophone {

struct SfzInstrument {
    std::string name;
    std::string folder;      ///< of the samples, from the SFZ file's; empty or ending in '/'
    std::string ending;      ///< of the samples' names, with the dot
    double gainDecibels = 0; ///< of the samples; the SFZ takes it back
    double tailDecibels = -60;
    bool keysHavePitches = true; ///< false: neighbours of a sampled key sound at its pitch
    /// Time in which a released key falls by 60 dB. Nothing: keys ring on.
    std::optional<double> releaseSeconds;
};

/// Returns the text of the file. Velocities only select samples, which are as loud as the strikes
/// were.
std::string sfzText(const SfzInstrument& instrument, std::span<const PlannedSample> samples);

} // namespace idiophone
