// A strike that has happened: its time, object and place.
#pragma once

#include "Synth/Strike.h"

#include <array>
#include <cstddef>

namespace idiophone {

struct PlacedImpact {
    double seconds = 0;
    std::size_t slot = 0;
    Strike strike;
    std::array<double, 3> pointMetres{}; ///< on the object's mesh, not scaled
};

} // namespace idiophone
