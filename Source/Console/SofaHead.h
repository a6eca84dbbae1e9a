// Measured heads from SOFA files (AES69).
#pragma once

#include "Scene/HeadResponses.h"

#include <filesystem>
#include <memory>

namespace idiophone {

/// One head's two ears in free field (SimpleFreeFieldHRIR) at a sample rate. The error names the
/// file. libmysofa falls over some damaged files: it reads in a process of its own, the command
/// `sofa-table` of this program.
Result<std::shared_ptr<const HeadResponses>> readSofaHead(const std::filesystem::path& file,
                                                          int sampleRateHz);

} // namespace idiophone
