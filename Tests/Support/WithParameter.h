// Parameter values but for one of them.
#pragma once

#include "Parameters/ParameterTable.h"

namespace idiophone::test {

inline ParameterValues with(ParameterValues parameters, ParameterId parameter, double value) {
    parameters.set(parameter, value);
    return parameters;
}

} // namespace idiophone::test
