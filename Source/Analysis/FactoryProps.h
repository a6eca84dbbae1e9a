// The bodies and floors of the factory scenes, from generated meshes. docs/scenes.md lists their
// dimensions.
#pragma once

#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <string>
#include <vector>

namespace idiophone {

/// Returns the names: "die" and so on.
std::vector<std::string> factoryPropNames();

/// Analyses one of them, in seconds. Errors: an unknown name, or `cancelledMessage`.
Result<ModalObject> makeFactoryProp(const std::string& name, const WorkControl& control = {});

} // namespace idiophone
