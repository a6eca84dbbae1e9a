// The options of `idiophone sample`, and the strikes that they mean.
#pragma once

#include "Sampling/SampleTask.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

struct SampleOptions {
    std::string instrument;
    std::filesystem::path folder;
    std::vector<int> keys; ///< lowest and highest, or none
    SampleChoices choices;
    std::optional<int> places;
    std::string ending = "wav";
    int sampleRateHz = 48000;
    SampleExportSettings files = {};
    std::vector<std::string> assignments;
    unsigned threads = 0;
    bool json = false;
};

/// Loads the preset, or for places the object, and plans its strikes. Warns on standard error of
/// parameters without effect.
Result<SampleTask> planSampling(const SampleOptions& options);

} // namespace idiophone
