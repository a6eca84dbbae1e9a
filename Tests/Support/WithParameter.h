// Returns parameter values with one of them changed.
#pragma once

#include "Parameters/ParameterTable.h"

namespace idiophone::test {

inline ParameterValues with(ParameterValues parameters, ParameterId parameter, double value) {
    parameters.set(parameter, value);
    return parameters;
}

} // namespace idiophone::test
