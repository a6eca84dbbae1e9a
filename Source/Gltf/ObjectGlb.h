// SPDX-License-Identifier: Apache-2.0
// Writes a modal object as a glTF file that other programs can show and strike.
#pragma once

#include "Object/ModalObject.h"

#include <cstddef>
#include <vector>

namespace idiophone {

/// Returns a .glb file with one node: the object's mesh, and its modes, material, finish and mass
/// as KHR_audio_rigid_bodies. The loudest modes come first. An extension of ours keeps what the
/// draft has no place for, so that `objectOf` returns the same object, bit for bit. The object must
/// have passed `validated` and have a mode that rings. The same object always gives the same bytes.
std::vector<std::byte> encodeGlb(const ModalObject& object);

} // namespace idiophone
