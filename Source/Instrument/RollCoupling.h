// Finds the modes of an object that a roll may drive harder than by its low-pass alone, at the
// frequencies at which they sound now. ContactForce decides how hard.
#pragma once

#include "Instrument/LowestModes.h"
#include "Synth/ContactForce.h"
#include "Synth/SynthesiserSlot.h"

#include <array>
#include <cstddef>
#include <span>

namespace idiophone {

class CoupledModes {
public:
    void add(const CoupledMode& mode) { modes[used++] = mode; }
    std::span<const CoupledMode> span() const { return std::span(modes).first(used); }

private:
    std::array<CoupledMode, ContactForce::maxCoupledModes> modes;
    std::size_t used = 0;
};

/// Returns the modes that oscillate and have at least 20 Hz among the object's lowest modes, under
/// the settings. Their poles equal the synthesiser's. Does not allocate.
CoupledModes coupledModes(const LowestModes& lowestModes,
                          const SynthesiserSlot& slot,
                          const SynthesisSettings& settings);

} // namespace idiophone
