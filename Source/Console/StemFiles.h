// Writes the stems of a scene to files that begin and end together.
#pragma once

#include "Console/Recording.h"
#include "Instrument/StereoSpan.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace idiophone {

/// Each stem has a room of its own and no limiter, so the files sum to the mix where its limiter
/// does not act. Stems that stay silent have no file.
class StemFiles {
public:
    /// `names` are those of the files, without folder and ending.
    StemFiles(std::filesystem::path folder,
              std::vector<std::string> names,
              const RecordingFormat& format,
              const ParameterValues& parameters);

    /// Appends the first samples of each stem.
    Result<void> add(std::span<const StereoSpan> stems, std::size_t sampleCount);
    /// Completes the files, with this length or more.
    Result<void> finish(std::int64_t samples);

    /// Returns the name and figures of each file.
    nlohmann::ordered_json statistics() const;

private:
    Result<void> begin(std::size_t stem);

    std::filesystem::path folder;
    std::vector<std::string> names;
    RecordingFormat format;
    ParameterValues parameters;
    std::vector<std::unique_ptr<Recording>> recordings; ///< [names], null while silent
    std::size_t samplesBefore = 0;
};

} // namespace idiophone
