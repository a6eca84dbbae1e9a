// Describes objects made from files, in sentences and figures for the window.
#pragma once

#include "Object/ModalObject.h"
#include "Parameters/ParameterTable.h"

#include <array>
#include <optional>
#include <string>

namespace idiophone {

/// Returns a summary such as "171 modes from 412.3 Hz to 44.0 kHz; 32.7 kg of Steel, 200 x 200 x
/// 200 mm".
std::string summaryOf(const ModalObject& object);

/// Returns the sides of the bounding box.
std::array<double, 3> sidesMetresOf(const ModalObject& object);

/// Returns the sentence about the mesh's unit, then the notes of the object's analysis.
std::string notesOf(const ModalObject& object, const std::string& unitSentence);

/// Returns the material that an object has under these parameters.
std::string materialNameOf(const ModalObject& object, const ParameterValues& values);

/// Returns the thickness of a shell under these parameters.
std::optional<double> thicknessMetresOf(const ModalObject& object, const ParameterValues& values);

/// Returns a name made from the content, so that different objects have different names.
std::string uniqueName(const ModalObject& object);

} // namespace idiophone
