// Records the output stage to a stereo audio file and reports on the sound.
#pragma once

#include "AudioFiles/AudioFileWriter.h"
#include "Output/OutputStage.h"
#include "Parameters/ParameterTable.h"
#include "Sampling/LoudnessMeter.h"

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

/// How the sound is rendered and written, from the options of `strike` and `render`.
struct RecordingFormat {
    std::filesystem::path file;
    int sampleRateHz = 48000;
    int blockSize = 64;            ///< samples rendered at a time
    std::optional<int> bitDepth;   ///< nothing: the usual one of the file
    std::optional<double> seconds; ///< length; nothing: until silence
};

/// Adds -o, --sample-rate, --block-size, --bit-depth and --seconds.
void addRecordingOptions(CLI::App& command, RecordingFormat& format);

class Recording {
public:
    static Result<std::unique_ptr<Recording>> start(const RecordingFormat& format,
                                                    const ParameterValues& parameters);
    ~Recording();

    const RecordingFormat format;

    /// Appends a block of at most the block size; both channels have equal length. Fails if the
    /// output is not finite.
    Result<void> add(std::span<const float> left, std::span<const float> right);

    /// Appends any number of samples, block by block.
    Result<void> addAll(std::span<const float> left, std::span<const float> right);

    /// Ends the file at its last sound, but not before `minimumSamples`. The silence after the last
    /// sound is dropped, because its length depends on the block size.
    Result<void> finish(std::int64_t minimumSamples);

    /// See OutputStage.
    void hush(std::size_t unanswered) { output.hush(unanswered); }
    bool silent() const { return output.silent(); } ///< no reverb is left

    /// samples, seconds, sample_rate_hz, peak_dbfs, integrated_lufs: null for silence.
    nlohmann::ordered_json statistics() const;
    /// "3.21 s at 48000 Hz, peak -6.0 dBFS".
    std::string summary() const;

private:
    Recording(RecordingFormat format, const ParameterValues& parameters);
    void warnOfPeak() const;
    Result<void> writeSilence(std::int64_t samples);
    Result<void> write(int samples);

    ParameterValues parameters;
    std::unique_ptr<AudioFileWriter> writer;
    OutputStage output;
    std::vector<float> writtenLeft, writtenRight, interleaved;
    LoudnessMeter meter;
    std::int64_t written = 0;
    std::int64_t heldBack = 0; ///< zeros not written yet
    double highest = 0;        ///< full scale 1
};

} // namespace idiophone
