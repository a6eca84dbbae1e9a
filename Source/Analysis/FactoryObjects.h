// The modal objects that ship with the instrument, made from generated meshes: what
// `idiophone factory` writes into Resources/Objects.
#pragma once

#include "Analysis/AnalysisControl.h"
#include "Object/ModalObject.h"

#include <string>
#include <vector>

namespace idiophone {

/// Those of FactoryBars, FactoryShapes and FactoryStage.
std::vector<std::string> factoryObjectNames();

/// Analyses one of them, in seconds. Errors: an unknown name, or `cancelledMessage`.
Result<ModalObject> makeFactoryObject(const std::string& name, const AnalysisControl& control = {});

} // namespace idiophone
