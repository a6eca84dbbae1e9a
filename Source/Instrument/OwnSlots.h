// Finds which slots of an instrument share an object.
#pragma once

#include "Instrument/Instrument.h"

#include <cstddef>
#include <vector>

namespace idiophone {

/// Returns one slot for each object: the one nearest to the object's own size. Ascending.
std::vector<std::size_t> ownSlots(const Instrument& instrument);

/// Returns for each slot the index into `ownSlots` of the slot with its object.
std::vector<int> objectsOfSlots(const Instrument& instrument);

} // namespace idiophone
