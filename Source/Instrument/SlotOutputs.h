// On which output each slot sounds: all on the main one, or by parts of a kit, octaves or keys.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/StereoSpan.h"
#include "Parameters/ParameterTable.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace idiophone {

/// Constructed off the audio thread; the rest is for the audio thread and neither allocates, locks
/// nor throws. All slots are on the main output at first, and those of a stage always.
class SlotOutputs {
public:
    explicit SlotOutputs(const Instrument& instrument);

    /// Finds the outputs by a choice of ParameterId::outputs. A slot whose output is not connected
    /// sounds on the main one. Returns whether they differ from those in effect.
    bool find(int choice, OutputSet connected);
    /// Puts the outputs that were found last into effect.
    void change() {
        inEffect = found; // of equal size, so nothing is allocated
        differs = false;
    }

    /// Returns the output of each slot in effect, from 0 on.
    std::span<const std::uint8_t> ofSlots() const { return inEffect; }

private:
    std::array<std::vector<std::uint8_t>, outputChoices> wanted; ///< [choices][slots]
    std::vector<std::uint8_t> inEffect, found;                   ///< [slots]
    int foundFor = mainOutput;                                   ///< the last choice
    OutputSet foundAmong{1};                                     ///< connected then
    bool differs = false;
};

} // namespace idiophone
