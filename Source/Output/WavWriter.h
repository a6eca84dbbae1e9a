// Writes a WAV file beside its place and moves it there once it is complete.
#pragma once

#include "Object/Result.h"

#include <filesystem>
#include <memory>

namespace juce {
class AudioFormatWriter;
class FileOutputStream;
} // namespace juce

namespace idiophone {

class WavWriter {
public:
    /// `bitDepth` is 16 or 24 for whole numbers, which clip at full scale, or 32 for floats, which
    /// do not. A link stays a link to the file. The error names a file that cannot be written, for
    /// example a device or a pipe.
    static Result<std::unique_ptr<WavWriter>>
    create(const std::filesystem::path& file, int sampleRateHz, int channelCount, int bitDepth);

    /// Removes an unfinished file.
    ~WavWriter();
    WavWriter(const WavWriter&) = delete;
    WavWriter& operator=(const WavWriter&) = delete;

    /// Appends `sampleCount` samples of every channel.
    Result<void> write(const float* const* channels, int sampleCount);
    Result<void> finish();

private:
    explicit WavWriter(const std::filesystem::path& file);
    bool writeRounded(const float* const* channels, int sampleCount);
    tl::unexpected<Error> fault() const;

    std::filesystem::path file;
    std::filesystem::path partial; ///< until it is complete
    std::unique_ptr<juce::AudioFormatWriter> writer;
    juce::FileOutputStream* stream = nullptr; ///< owned by the writer
};

} // namespace idiophone
