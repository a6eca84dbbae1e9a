// Measures the peak of a single strike by rendering it.
#pragma once

#include "Instrument/Instrument.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Surface.h"

#include <memory>

namespace idiophone {

/// Returns the highest peak of the instrument's keys, struck one at a time at velocity 127; full
/// scale is 1, before `level`. Tries eight keys from the lowest to the highest, and renders only
/// the first 50 ms of each strike. Takes some hundredths of a second; not for the audio thread.
double loudestStrikePeak(const std::shared_ptr<const Instrument>& instrument,
                         const Surface& surface,
                         double sampleRateHz,
                         const ParameterValues& parameters);

} // namespace idiophone
