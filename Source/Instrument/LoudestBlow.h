// How high a single blow peaks, heard rather than predicted.
#pragma once

#include "Instrument/Instrument.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Surface.h"

#include <memory>

namespace idiophone {

/// The highest peak of the instrument's keys struck one at a time at velocity 127, of the parts of
/// a second in which blows peak; full scale is 1, before `level`. Eight keys from the lowest to the
/// highest are tried. Renders, so it takes some hundredths of a second; not for the audio thread.
double loudestBlowPeak(const std::shared_ptr<const Instrument>& instrument,
                       const Surface& surface,
                       double sampleRateHz,
                       const ParameterValues& parameters);

} // namespace idiophone
