// Reads measured heads from SOFA files (AES69).
#pragma once

#include "World/HeadResponses.h"

#include <filesystem>
#include <memory>

namespace idiophone {

/// Reads the responses of both ears in free field (SimpleFreeFieldHRIR) at a sample rate. The error
/// names the file. libmysofa crashes on some damaged files, so it runs in a process of its own: the
/// command `sofa-table` of this program.
Result<std::shared_ptr<const HeadResponses>> readSofaHead(const std::filesystem::path& file,
                                                          int sampleRateHz);

} // namespace idiophone
