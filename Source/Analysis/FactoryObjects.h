// The modal objects that ship with the instrument, made from generated meshes: the bars of
// FactoryBars, plates, rings, bowls, bells, tubes, and the bodies and floors of the scenes.
// docs/instruments.md and docs/scenes.md list their dimensions and the sources. `idiophone factory`
// writes them to Resources/Objects.
#pragma once

#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <string>
#include <vector>

namespace idiophone {

/// Returns the names: "plate" and so on. A keyboard has one per note, "tubular-bell-60".
std::vector<std::string> factoryObjectNames();

/// Analyses the object of that name, which takes seconds. Errors: an unknown name, or
/// `cancelledMessage`.
Result<ModalObject> makeFactoryObject(const std::string& name, const WorkControl& control = {});

} // namespace idiophone
