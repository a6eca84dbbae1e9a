// A change of one parameter by hand that is over at once.
#pragma once

#include "Editor/ProcessorView.h"

namespace idiophone {

/// One gesture. A figure of a material or mallet makes it the custom one.
inline void changeOnce(ProcessorView& view, ParameterId parameter, double value) {
    view.beginParameterChange(parameter);
    view.makeCustom(parameter);
    view.changeParameter(parameter, value);
    view.endParameterChange(parameter);
}

} // namespace idiophone
