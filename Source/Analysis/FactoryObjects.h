// The modal objects that ship with the instrument, made from generated meshes. `idiophone factory`
// writes them to Resources/Objects.
#pragma once

#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <string>
#include <vector>

namespace idiophone {

/// Returns the names of all objects of FactoryBars and FactoryShapes.
std::vector<std::string> factoryObjectNames();

/// Analyses the object of that name, which takes seconds. Errors: an unknown name, or
/// `cancelledMessage`.
Result<ModalObject> makeFactoryObject(const std::string& name, const WorkControl& control = {});

} // namespace idiophone
