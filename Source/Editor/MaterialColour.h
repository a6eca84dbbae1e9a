// The colour in which a material is drawn.
#pragma once

#include "Object/Material.h"

#include <array>

namespace idiophone {

/// Red, green and blue, 0 to 1. Materials of the library have a fixed colour; for others it is
/// guessed from their figures.
std::array<float, 3> colourOf(const Material& material);

} // namespace idiophone
