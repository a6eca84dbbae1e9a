// The tubes of the factory instruments: tubular bells, one per note, and a wind chime.
#pragma once

#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace idiophone {

/// Returns "tubular-bell-60" to "tubular-bell-77", and "wind-chime".
std::vector<std::string> factoryTubeNames();

/// Tunes the tube of that name, or returns nothing if there is none. Errors: `cancelledMessage`.
std::optional<Result<ModalObject>> makeFactoryTube(std::string_view name,
                                                   const WorkControl& control = {});

} // namespace idiophone
