// Reads and writes surfaces as JSON text. `idiophone surface` saves them, and docs/surfaces.md
// specifies them.
#pragma once

#include "Synth/Surface.h"

#include <string>
#include <string_view>

namespace idiophone {

inline constexpr int surfaceFormatVersion = 1;

/// Parses and validates a surface file; `file` stands for it in errors. The name, slowest speed and
/// roughness are optional; the slowest speed's default is a tenth of v_max. At most 64 KiB. Not for
/// the audio thread.
Result<Surface> parseSurface(std::string_view text, std::string_view file);

/// Returns the surface as JSON text that `parseSurface` reads back to an equal surface.
std::string encodeSurface(const Surface& surface);

} // namespace idiophone
