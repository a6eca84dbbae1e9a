// A WAV file read whole, for what is measured on recordings.
#pragma once

#include "Object/Result.h"

#include <filesystem>
#include <vector>

namespace idiophone {

struct MonoRecording {
    std::vector<float> samples; ///< the mean of the channels, full scale 1
    double sampleRateHz = 0;
};

/// Up to ten minutes and 1 GB in any format of a WAV file. The error names a file that is missing,
/// no WAV file, damaged or too long.
Result<MonoRecording> readWav(const std::filesystem::path& file);

} // namespace idiophone
