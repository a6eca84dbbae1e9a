// The places where the keys strike an object, for pictures of it.
#pragma once

#include "Instrument/Instrument.h"

#include <array>
#include <cstddef>
#include <vector>

namespace idiophone {

/// Returns the places along the path on which keys strike a slot, in metres on its object; empty if
/// no key plays it. Not for the audio thread.
std::vector<std::array<double, 3>> struckPlaces(const Instrument& instrument, std::size_t slot);

} // namespace idiophone
