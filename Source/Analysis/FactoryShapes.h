// The factory objects that are not bars, from generated meshes: plates, rings, bowls, bells, tubes,
// and the bodies and floors of the scenes. docs/instruments.md and docs/scenes.md list their
// dimensions and the sources.
#pragma once

#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <string>
#include <vector>

namespace idiophone {

/// Returns the names: "plate" and so on. A keyboard of tubes has one per note, "tubular-bell-60".
std::vector<std::string> factoryShapeNames();

/// Analyses the object of that name, which takes seconds. Errors: an unknown name, or
/// `cancelledMessage`.
Result<ModalObject> makeFactoryShape(const std::string& name, const WorkControl& control = {});

} // namespace idiophone
