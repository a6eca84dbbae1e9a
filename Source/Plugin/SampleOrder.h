// An order of the window: a sound to be sampled, with the settings of the export.
#pragma once

#include "Editor/SampleView.h"
#include "Sampling/SampleTask.h"

#include <cstddef>
#include <filesystem>

namespace idiophone {

struct SampleOrder {
    SampledInstrument sampled; ///< without an instrument if none plays
    std::size_t slot = 0;      ///< of the object whose places are struck
    SampleSettings settings;
    std::filesystem::path folder = {}; ///< of the files, which exists; empty: only estimate
};

/// Returns the strikes of the order. The error is a sentence for the window: why this sound cannot
/// be sampled so. Any thread except the audio thread.
Result<SampleTask> taskOf(const SampleOrder& order);

/// Returns the settings of the files.
SampleExportSettings exportSettingsOf(const SampleOrder& order);

} // namespace idiophone
