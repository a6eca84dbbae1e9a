// Measures the files of an export as they lie on the disk.
#pragma once

#include "Object/WorkControl.h"
#include "Sampling/SampleExport.h"

#include <filesystem>
#include <span>
#include <vector>

namespace idiophone {

struct SampleFigures {
    double seconds = 0;
    double peakDecibels = 0;      ///< relative to full scale
    double loudestMomentLufs = 0; ///< of the loudest 400 ms
};

/// Returns the figures of each job's file. Fails if a file cannot be read, or if the work is
/// cancelled.
Result<std::vector<SampleFigures>> figuresOf(std::span<const SampleJob> jobs,
                                             const WorkControl& control = {});

} // namespace idiophone
