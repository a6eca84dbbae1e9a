// Reads a whole audio file, for measurements on recordings.
#pragma once

#include "Object/Result.h"

#include <filesystem>
#include <vector>

namespace idiophone {

struct MonoRecording {
    std::vector<float> samples; ///< mean of the channels, full scale 1
    double sampleRateHz = 0;
};

struct InterleavedRecording {
    std::vector<float> samples; ///< frame by frame, full scale 1
    int channelCount = 0;
    double sampleRateHz = 0;
};

/// Reads up to ten minutes and 1 GB of a WAV, FLAC or AIFF file. A WAV file of unknown length, as
/// programs write it to a pipe, is read to its end. The error names a file that is missing, of
/// another kind, damaged or too long. Any thread.
Result<MonoRecording> readRecording(const std::filesystem::path& file);
/// Does the same, and keeps the channels.
Result<InterleavedRecording> readChannels(const std::filesystem::path& file);

} // namespace idiophone
