// What parameters mean to the synthesiser where no Player stands between: for impulses, which know
// neither keys nor bends.
#pragma once

#include "Parameters/ParameterTable.h"
#include "Synth/SynthesisSettings.h"

namespace idiophone {

SynthesisSettings synthesisSettings(const ParameterValues& values);

} // namespace idiophone
