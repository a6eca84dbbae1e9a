// Renders strikes into files, on several threads, and goes on where it was interrupted.
#pragma once

#include "Sampling/StrikeSampler.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace idiophone {

class WorkTeam;

struct SampleJob {
    SampledStrike strike;
    std::filesystem::path file; ///< ends in ".wav" or ".flac"; unique among the jobs
};

struct SampleExportSettings {
    std::filesystem::path folder = {}; ///< exists; gets the record of the settings
    int bitDepth = 24;                 ///< 16 or 24
    double tailDecibels = -60;         ///< where a sample ends, relative to its peak, negative
    double longestSeconds = 60;        ///< of a sample
    /// Gain of all samples. Nothing: the loudest velocity's attacks peak at `headroomDecibels`.
    std::optional<double> gainDecibels = {};
};

inline constexpr double headroomDecibels = -3;

/// The record of the settings in a folder of samples.
inline constexpr auto sampleRecordName = "samples.json";

struct ExportedSamples {
    double gainDecibels = 0;
    std::size_t rendered = 0; ///< files that did not exist yet
    std::size_t clipped = 0;  ///< rendered files that exceed full scale
};

/// Renders the files that do not exist yet. Each appears only when it is complete. They do not
/// depend on the team. The folder keeps a record of the instrument's values and the settings; the
/// error says if its samples have others. Other errors: a file that cannot be written, silence, a
/// sound that is not finite, cancellation. Not for the audio thread.
Result<ExportedSamples> exportSamples(const SampledInstrument& sampled,
                                      std::span<const SampleJob> jobs,
                                      const SampleExportSettings& settings,
                                      WorkTeam& team,
                                      const WorkControl& control = {});

} // namespace idiophone
