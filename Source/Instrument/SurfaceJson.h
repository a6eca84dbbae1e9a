// A surface as presets and scenes have it in JSON.
#pragma once

#include "Instrument/JsonPlace.h"
#include "Instrument/SurfaceFile.h"

namespace idiophone {

/// As a surface file holds it. What is wrong throws JsonPlace::Fault.
inline Surface surfaceAt(const JsonPlace& place) {
    auto surface = parseSurface(place.json().dump(), place.name());
    if (!surface)
        throw JsonPlace::Fault{surface.error().message};
    return std::move(*surface);
}

} // namespace idiophone
