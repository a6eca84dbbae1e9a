// Makes a key map for an object that has no instrument yet: default strike places, and strike paths
// in metres of its mesh.
#pragma once

#include "Instrument/Preset.h"
#include "Object/ModalObject.h"

#include <array>
#include <string>
#include <vector>

namespace idiophone {

/// These functions are not for the audio thread.

/// Returns a map of `kind`, not `bars`, with keys C2 to C7 and the path of `pathOverTop`. Scaled
/// objects are struck at the place of the path where the lowest modes move most.
KeyMap singleObjectMap(const ModalObject& object, const std::string& name, KeyMapKind kind);

/// Returns a path between the ends of the object's longest side, over the surface visible from
/// above, in units of its box. On an upright object it leads up the front. It goes round holes.
std::vector<std::array<double, 3>> pathOverTop(const ModalObject& object);

/// Convert a key map's path to metres of the object's mesh and back. `relativePath` keeps at most
/// 1000 finite points, evenly spread; the result may be empty.
std::vector<std::array<double, 3>> pathMetres(const ModalObject& object, const KeyMap& map);
std::vector<std::array<double, 3>>
relativePath(const ModalObject& object, const std::vector<std::array<double, 3>>& pathMetres);

} // namespace idiophone
