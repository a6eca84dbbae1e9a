// The factory's solid bodies that are struck: a triangle, a clave, an anvil. docs/instruments.md
// lists the sources of their dimensions.
#pragma once

#include "Analysis/FactoryShape.h"

#include <span>

namespace idiophone {

std::span<const FactoryShape> factoryBlocks();

} // namespace idiophone
