// Reads and writes surfaces as JSON; `idiophone surface` saves them, and presets and scenes contain
// them. docs/surfaces.md specifies them.
#pragma once

#include "Synth/Surface.h"

#include <string>

namespace idiophone {

class JsonPlace;

inline constexpr int surfaceFormatVersion = 1;

/// Reads and validates a surface. The name, slowest speed and roughness are optional; the slowest
/// speed's default is a tenth of v_max. An error throws JsonPlace::Fault. Not for the audio thread.
Surface surfaceAt(const JsonPlace& place);

/// Returns the surface as JSON text that `surfaceAt` reads back to an equal surface.
std::string encodeSurface(const Surface& surface);

} // namespace idiophone
