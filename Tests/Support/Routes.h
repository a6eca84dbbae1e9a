// Returns parameter values with a route of modulation.
#pragma once

#include "Parameters/ModulationTable.h"

#include <cstddef>

namespace idiophone::test {

/// The route with that number moves the target by an amount in percent.
inline ParameterValues routed(std::size_t number,
                              ModulationSource source,
                              ParameterId target,
                              double amountPercent,
                              ParameterValues values = {}) {
    const auto& route = modulationRoutes[number];
    values.set(route.source, static_cast<double>(source));
    values.set(route.target, modulationTargetChoice(target));
    values.set(route.amount, amountPercent);
    return values;
}

} // namespace idiophone::test
