// Changes one parameter by hand in a single gesture.
#pragma once

#include "Editor/ProcessorView.h"

namespace idiophone {

/// If the parameter is a figure of a material or mallet, the custom one is selected.
inline void changeOnce(ProcessorView& view, ParameterId parameter, double value) {
    view.parameters.beginChange(parameter);
    view.parameters.makeCustom(parameter);
    view.parameters.change(parameter, value);
    view.parameters.endChange(parameter);
}

} // namespace idiophone
