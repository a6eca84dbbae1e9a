// Surfaces as JSON text, as `idiophone surface` saves them; docs/surfaces.md specifies it.
#pragma once

#include "Synth/Surface.h"

#include <string>
#include <string_view>

namespace idiophone {

inline constexpr int surfaceFormatVersion = 1;

/// Parses and validates a surface file; `file` stands for it in errors. A figure that may be left
/// out (name, slowest speed, roughness) has its default, the slowest speed a tenth of v_max. At
/// most 64 KiB. Not for the audio thread.
Result<Surface> parseSurface(std::string_view text, std::string_view file);

/// The surface as JSON text that `parseSurface` reads back to an equal surface.
std::string encodeSurface(const Surface& surface);

} // namespace idiophone
