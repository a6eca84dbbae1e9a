// Reads a surface from the JSON of presets and scenes.
#pragma once

#include "Instrument/JsonPlace.h"
#include "Instrument/SurfaceFile.h"

namespace idiophone {

/// Reads a surface in the form of a surface file. An error throws JsonPlace::Fault.
inline Surface surfaceAt(const JsonPlace& place) {
    auto surface = parseSurface(place.json().dump(), place.name());
    if (!surface)
        throw JsonPlace::Fault{surface.error().message};
    return std::move(*surface);
}

} // namespace idiophone
