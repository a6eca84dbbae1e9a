// Reads a whole WAV file, for measurements on recordings.
#pragma once

#include "Object/Result.h"

#include <filesystem>
#include <vector>

namespace idiophone {

struct MonoRecording {
    std::vector<float> samples; ///< mean of the channels, full scale 1
    double sampleRateHz = 0;
};

/// Reads up to ten minutes and 1 GB in any WAV format. The error names a file that is missing, not
/// a WAV file, damaged or too long.
Result<MonoRecording> readWav(const std::filesystem::path& file);

} // namespace idiophone
