// Which modes a strike makes loudest, for people to read; rendering does not need it.
#pragma once

#include "Object/ModalObject.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Strike.h"

#include <vector>

namespace idiophone {

struct StruckMode {
    double frequencyHz = 0;      ///< damped, as it sounds
    double relativeDecibels = 0; ///< of its first amplitude, against the loudest
};
using StruckModes = std::vector<StruckMode>;

/// At most `count` of them below the Nyquist frequency, loudest first. A mode's first amplitude is
/// its residue at the strike, times the spectrum of the raised-cosine pulse there.
StruckModes loudestModes(const ModalObject& object,
                         const Strike& strike,
                         const ParameterValues& parameters,
                         double sampleRateHz,
                         std::size_t count);

} // namespace idiophone
