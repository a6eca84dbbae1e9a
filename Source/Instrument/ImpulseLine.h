// A blow as a line of a list of impulses (docs/impulses.md).
#pragma once

#include "Instrument/PlacedBlow.h"
#include "Synth/Synthesiser.h"

#include <string>

namespace idiophone {

/// With its line break. Bodies are told apart by their slots. For any thread; allocates.
std::string impulseLine(const SynthesiserSlot& struck, const PlacedBlow& blow);

} // namespace idiophone
