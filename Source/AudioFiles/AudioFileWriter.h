// Writes an audio file beside its place and moves it there once it is complete.
#pragma once

#include "Object/Result.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace idiophone {

class AudioFileWriter {
public:
    /// Writes FLAC if the name ends in ".flac", else WAV. `bitDepth` is 16 or 24 for whole numbers,
    /// which clip at full scale, or 32 for floats, which do not; FLAC has whole numbers only. A
    /// link stays a link to the file. The error names a file that cannot be written, for example a
    /// device or a pipe.
    static Result<std::unique_ptr<AudioFileWriter>>
    create(const std::filesystem::path& file, int sampleRateHz, int channelCount, int bitDepth);

    /// Returns 32, or 24 if the name makes the file FLAC.
    static int usualBitDepth(const std::filesystem::path& file);

    /// Removes an unfinished file.
    ~AudioFileWriter();
    AudioFileWriter(const AudioFileWriter&) = delete;
    AudioFileWriter& operator=(const AudioFileWriter&) = delete;

    /// Appends `sampleCount` samples of every channel.
    Result<void> write(const float* const* channels, int sampleCount);
    Result<void> finish();

private:
    struct Target;

    AudioFileWriter(const std::filesystem::path& file, int channelCount, int bitDepth);
    bool writePiece(const float* const* channels, std::size_t begin, std::size_t count);
    tl::unexpected<Error> fault() const;

    std::filesystem::path file;
    std::filesystem::path partial; ///< until it is complete
    std::size_t channelCount;
    int bitDepth;
    std::unique_ptr<Target> target;
    std::vector<float> floats; ///< interleaved
    std::vector<int> steps;    ///< interleaved whole numbers, in the upper bits
};

} // namespace idiophone
