// Estimates how many samples a task has, and how large they will be.
#pragma once

#include "Sampling/SampleTask.h"

#include <cstddef>

namespace idiophone {

struct SampleEstimate {
    std::size_t samples = 0;
    double seconds = 0; ///< of all samples together
    double bytes = 0;   ///< of all files together
};

/// Renders the first, the middle and the last sample, and interpolates the lengths of the others.
/// The errors are those of `sampleStrike`. Not for the audio thread.
Result<SampleEstimate> estimateSamples(const SampleTask& task,
                                       const SampleExportSettings& settings,
                                       const WorkControl& control = {});

} // namespace idiophone
