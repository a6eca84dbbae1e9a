// Plays impulses on modal objects directly, without keys or mallets.
#pragma once

#include "Console/Recording.h"
#include "Console/SongRender.h"

#include <filesystem>
#include <span>

namespace idiophone {

/// Reads the impulses and their objects. Renders up to the recording's length, or else to silence
/// after the last contact. `assigned` are the parameters set by name. Impulses act at their time to
/// a fraction of a sample.
Result<RenderTally> renderImpulses(const std::filesystem::path& file,
                                   const ParameterValues& parameters,
                                   std::span<const ParameterId> assigned,
                                   Recording& recording);

} // namespace idiophone
