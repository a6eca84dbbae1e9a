#include "Plugin/ControllerAssignments.h"

#include <cmath>

namespace idiophone {

double controlledValue(const ParameterInfo& info, int controllerValue) noexcept {
    const double place = controllerValue / 127.0;
    const auto names = choiceNames(info.parameter);
    return names.empty() ? info.fromNormalised(place)
                         : std::round(place * static_cast<double>(names.size() - 1));
}

} // namespace idiophone
