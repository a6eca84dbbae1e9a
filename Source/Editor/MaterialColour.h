// What colour a material is drawn in.
#pragma once

#include "Object/Material.h"

#include <array>

namespace idiophone {

/// Red, green and blue, 0 to 1. Of a material that nobody named, what its figures suggest: wood has
/// a grain, metals are heavy, stone, glass and ceramics stiff, plastics neither.
std::array<float, 3> colourOf(const Material& material);

} // namespace idiophone
