// Rods of the factory instruments that are held at one end or in their middle: the tine of an
// electric piano, the rod of a toy piano, the tuning fork.
#pragma once

#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace idiophone {

/// Returns "tine", "toy-piano-rod" and "tuning-fork".
std::vector<std::string> factoryRodNames();

/// Analyses the rod of that name, or returns nothing if there is none. Errors: `cancelledMessage`.
std::optional<Result<ModalObject>> makeFactoryRod(std::string_view name,
                                                  const WorkControl& control = {});

} // namespace idiophone
