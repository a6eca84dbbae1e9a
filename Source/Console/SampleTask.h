// The strikes that `idiophone sample` renders: of a preset's keys, or of places of one object.
#pragma once

#include "Sampling/SampleExport.h"
#include "Sampling/SamplePlan.h"

#include <filesystem>
#include <nlohmann/json.hpp>
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

/// Strikes of an instrument, and the figures of the report that name each.
struct SampleTask {
    SampledInstrument sampled;
    std::vector<SampleJob> jobs;
    std::vector<nlohmann::ordered_json> names; ///< [jobs]
    std::vector<PlannedSample> plan;           ///< [jobs] of keys; empty for places
};

/// Loads the preset, or for places the object, and plans its strikes. Warns on standard error of
/// parameters without effect.
Result<SampleTask> planSampling(const SampleOptions& options);

} // namespace idiophone
