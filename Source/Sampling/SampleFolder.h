// Exports a task into a folder, with the index that samplers and games read: an SFZ file for keys,
// a table for places.
#pragma once

#include "Sampling/SampleFigures.h"
#include "Sampling/SampleTask.h"

#include <filesystem>
#include <string>
#include <vector>

namespace idiophone {

struct SampleFolder {
    ExportedSamples exported;
    std::filesystem::path index;             ///< the SFZ file, or samples.csv
    std::vector<SampleFigures> figures = {}; ///< of places, in their order; empty for keys
};

/// Renders the samples that the folder lacks (`exportSamples`), then writes the index. The errors
/// are those of `exportSamples` and of files that cannot be written or read.
Result<SampleFolder> exportTask(const SampleTask& task,
                                const SampleExportSettings& settings,
                                WorkTeam& team,
                                const WorkControl& control = {});

/// Returns whether an export has begun in this folder.
bool holdsSamples(const std::filesystem::path& folder);

} // namespace idiophone
