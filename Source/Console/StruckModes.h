// Lists the loudest modes of a strike for people to read. Rendering does not need it.
#pragma once

#include "Object/ModalObject.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Strike.h"

#include <vector>

namespace idiophone {

struct StruckMode {
    double frequencyHz = 0;      ///< damped, as it sounds
    double relativeDecibels = 0; ///< initial amplitude relative to the loudest mode
};
using StruckModes = std::vector<StruckMode>;

/// Returns at most `count` modes below the Nyquist frequency, loudest first. A mode's initial
/// amplitude is its residue at the strike, times the spectrum of the raised-cosine pulse at its
/// frequency.
StruckModes loudestModes(const ModalObject& object,
                         const Strike& strike,
                         const ParameterValues& parameters,
                         double sampleRateHz,
                         std::size_t count);

} // namespace idiophone
