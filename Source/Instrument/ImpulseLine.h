// A blow as a line of a list of impulses (docs/impulses.md).
#pragma once

#include "Synth/Strike.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <cstdint>
#include <string>

namespace idiophone {

struct PlacedBlow {
    double seconds = 0;
    std::size_t slot = 0;
    Strike strike;
    std::array<double, 3> pointMetres{}; ///< on the object's mesh, not scaled
};

/// With its line break. Bodies are told apart by their slots.
std::string impulseLine(const SynthesiserSlot& struck, const PlacedBlow& blow);

} // namespace idiophone
