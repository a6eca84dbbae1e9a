// Reads a surface from the JSON of surface files, presets and scenes.
#pragma once

#include "Instrument/JsonPlace.h"
#include "Synth/Surface.h"

namespace idiophone {

/// Reads a surface in the form of a surface file. An error throws JsonPlace::Fault.
Surface surfaceAt(const JsonPlace& place);

} // namespace idiophone
