// The factory instruments that are not bars: plates, rings, bowls, bells and tubes, from generated
// meshes. docs/instruments.md lists their dimensions and the sources.
#pragma once

#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <string>
#include <vector>

namespace idiophone {

/// Returns the names: "plate" and so on. A keyboard of tubes has one per note, "tubular-bell-60".
std::vector<std::string> factoryShapeNames();

/// Analyses one of them, in seconds. Errors: an unknown name, or `cancelledMessage`.
Result<ModalObject> makeFactoryShape(const std::string& name, const WorkControl& control = {});

} // namespace idiophone
