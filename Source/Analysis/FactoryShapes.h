// The factory's instruments that are not bars: plates, rings, bowls, bells and tubes, from
// generated meshes. docs/instruments.md has their measures and where these come from.
#pragma once

#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <string>
#include <vector>

namespace idiophone {

/// "plate" and so on; of a keyboard of tubes one for each note, "tubular-bell-60".
std::vector<std::string> factoryShapeNames();

/// Analyses one of them, in seconds. Errors: an unknown name, or `cancelledMessage`.
Result<ModalObject> makeFactoryShape(const std::string& name, const WorkControl& control = {});

} // namespace idiophone
