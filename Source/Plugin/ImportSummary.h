// What there is to say of objects that are made of files.
#pragma once

#include "Object/ModalObject.h"

#include <string>

namespace idiophone {

/// "171 modes from 412 Hz to 44.0 kHz; 32.7 kg of Steel, 200 x 200 x 200 mm".
std::string summaryOf(const ModalObject& object);

/// The sentences on its unit and of its analysis, one after the other.
std::string notesOf(const ModalObject& object, const std::string& unitSentence);

/// "imported/teapot-5f3a9c01": another for every other object.
std::string uniqueName(const ModalObject& object);

} // namespace idiophone
