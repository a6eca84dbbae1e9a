// What colour a material is drawn in.
#pragma once

#include "Object/Material.h"

#include <array>

namespace idiophone {

/// Red, green and blue, 0 to 1: of the library's materials their own, of others what their figures
/// suggest.
std::array<float, 3> colourOf(const Material& material);

} // namespace idiophone
