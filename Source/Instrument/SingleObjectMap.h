// How keys play an object that nobody has made an instrument of yet: where they strike it by
// default, and strike paths in metres of its mesh.
#pragma once

#include "Instrument/Preset.h"
#include "Object/ModalObject.h"

#include <array>
#include <string>
#include <vector>

namespace idiophone {

/// Not for the audio thread, as all of these.

/// Keys C2 to C7 of the kind, which is not `bars`, with the path of `pathOverTop`. Scaled objects
/// are struck where along it most of their lowest modes move.
KeyMap singleObjectMap(const ModalObject& object, const std::string& name, KeyMapKind kind);

/// From one end of the object's longest side to the other over what is seen from above, in units of
/// its box; of what stands upright, up its front. Where the object has a hole the path goes
/// round it.
std::vector<std::array<double, 3>> pathOverTop(const ModalObject& object);

/// A key map's path in metres of the object's mesh, and back: of the points that are finite at most
/// 1000, evenly; empty where there are none.
std::vector<std::array<double, 3>> pathMetres(const ModalObject& object, const KeyMap& map);
std::vector<std::array<double, 3>>
relativePath(const ModalObject& object, const std::vector<std::array<double, 3>>& pathMetres);

} // namespace idiophone
