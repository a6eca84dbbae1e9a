// SPDX-License-Identifier: Apache-2.0
// The modal object that Idiophone keeps in its own glTF files, beside what the draft can say of it.
// Internal to Gltf.
#pragma once

#include "Gltf/AudioRigidBodies.h"

#include <optional>

namespace idiophone {

/// Returns the object from which the model was written, or nothing if another program wrote the
/// model or changed its numbers.
std::optional<ModalObject> ownObject(const GltfDocument& document, const GltfModalModel& model);

} // namespace idiophone
