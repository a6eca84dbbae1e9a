// The modes of an object that a roll may drive harder than by its low-pass alone, where and as they
// sound now. How hard it drives them is ContactForce's.
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

/// Returns those of the lowest modes of the slot's object that oscillate and are not below 20 Hz,
/// under the settings: poles as the synthesiser has them. Does not allocate.
CoupledModes coupledModes(const LowestModes& lowestModes,
                          const SynthesiserSlot& slot,
                          const SynthesisSettings& settings);

} // namespace idiophone
