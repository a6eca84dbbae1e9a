// SPDX-License-Identifier: Apache-2.0
// Reads modal objects of every format from memory. Needs no file system.
#pragma once

#include "Object/ModalObject.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace idiophone {

/// Reads an object from memory: a .glb file with all its buffers, or a .modal file. `name` stands
/// for the file in the error, which is one sentence. Not for the audio thread.
Result<ModalObject> readObject(std::span<const std::byte> bytes, std::string_view name);

} // namespace idiophone
