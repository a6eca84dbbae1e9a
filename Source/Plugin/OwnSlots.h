// Which of an instrument's slots are objects of their own, and which share one.
#pragma once

#include "Instrument/Instrument.h"

#include <cstddef>
#include <vector>

namespace idiophone {

/// The slots of an instrument that are objects of their own: of those that share an object the one
/// nearest to its own size. Ascending.
std::vector<std::size_t> ownSlots(const Instrument& instrument);

/// For each slot which of `ownSlots` has its object.
std::vector<int> objectsOfSlots(const Instrument& instrument);

} // namespace idiophone
