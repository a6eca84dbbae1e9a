// What there is to say of files that are opened and of the objects made of them.
#pragma once

#include "Object/ModalObject.h"

#include <filesystem>
#include <string>

namespace idiophone {

/// The extensions that the workshop reads, in any case.
bool isModalFile(const std::filesystem::path& file); ///< .modal
bool isMeshFile(const std::filesystem::path& file);  ///< .obj, .off, .ply, .stl

/// Without its folder.
std::string nameOf(const std::filesystem::path& file);

/// "171 modes from 12.5 to 44.0 kHz; 32.7 kg of Steel, 200 x 200 x 200 mm".
std::string summaryOf(const ModalObject& object);

/// The sentences on its unit and of its analysis, one after the other.
std::string notesOf(const ModalObject& object, const std::string& unitSentence);

/// "imported/teapot-5f3a9c01": another for every other object.
std::string uniqueName(const ModalObject& object);

} // namespace idiophone
