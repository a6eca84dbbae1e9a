// The factory's bells, bowls, glasses, gongs and hollow blocks: walls, most of them turned.
// docs/instruments.md lists the sources of their dimensions.
#pragma once

#include "Analysis/FactoryShape.h"

#include <span>

namespace idiophone {

std::span<const FactoryShape> factoryShells();

} // namespace idiophone
